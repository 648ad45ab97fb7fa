#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace laver {

/// The words of a SPIR-V module.
using Spirv = std::vector<std::uint32_t>;

/// How much time to spend on optimisation, which shortens compilation by the driver.
enum class Effort {
  None,      ///< not optimised: for tests
  Unrolled,  ///< loops unrolled, functions kept: for tests
  Quick,     ///< about 0.4 s: for kernels that a render waits for
  Thorough   ///< about 2 s: for embedded kernels
};

/// Compiles a complete compute kernel. Throws Error(Scene) with one `file:line: error: ...` line
/// per error; file and line follow the text's #line directives.
Spirv compileGlsl(const std::string& text, Effort effort);

/// Versions of the compiler and of this code: with the text, they determine the result.
std::string compilerVersion();

}  // namespace laver
