#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "kernels/keys.h"

namespace laver {

/// GLSL text of the kernels, whole: every #include is expanded, with #line directives that name
/// files.
std::string compose(const TraceKey& key);
std::string compose(const GatherKey& key);

/// The trace kernel's text up to its main function, followed by `main`: for tests that trace rays
/// of their own.
std::string composeWith(const TraceKey& key, std::string_view main);

/// A file of shaders/, as it was built in; empty if there is none of that path.
std::string_view shaderText(std::string_view path);

/// Expands each `#include "path"` once, the second time to nothing.
std::string expandIncludes(std::string_view text, const std::string& name);

}  // namespace laver
