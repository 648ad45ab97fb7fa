#pragma once
#include <span>

#include "kernels/compile.h"
#include "kernels/keys.h"

namespace laver {

/// A module that was composed and compiled when laver was built.
struct EmbeddedModule {
  const char* hash;  ///< hashOfKernel
  std::span<const std::uint32_t> words;
};

/// Defined in the source that host/kernels/embed.cpp writes; empty in programs that are linked
/// without it.
std::span<const EmbeddedModule> embeddedModules();

/// Texts of the kernels that most renders need.
std::vector<std::string> commonKernels();

/// Where a module came from.
enum class ModuleSource { Embedded, Cached, Compiled };

struct Module {
  Spirv words;
  ModuleSource source;
};

/// The module of a composed text: embedded, cached by an earlier run, or compiled and cached now.
/// Throws as compileGlsl() does.
Module moduleOf(const std::string& text);

}  // namespace laver
