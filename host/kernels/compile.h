#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace laver {

/// A module's words.
using Spirv = std::vector<std::uint32_t>;

/// How much time goes into a module that the driver then compiles sooner.
enum class Effort {
  None,     ///< as glslang makes it: for tests
  Quick,    ///< some 0.2 s: for kernels composed while a render waits
  Thorough  ///< some 2 s: for those that are embedded
};

/// SPIR-V of a whole compute kernel. Throws Error(Scene) with one `file:line: error: ...` line per
/// error, files as the text's #line directives name them.
Spirv compileGlsl(const std::string& text, Effort effort);

/// What the result depends on beside the text: versions of the compiler and of this code.
std::string compilerVersion();

}  // namespace laver
