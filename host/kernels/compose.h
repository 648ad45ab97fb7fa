#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "kernels/keys.h"

namespace laver {

/// Complete GLSL text of a kernel: every #include is expanded, with #line directives that name the
/// files.
std::string compose(const TraceKey& key);
std::string compose(const GatherKey& key);

/// What a kernel knows of materials, with includes that are not expanded: the struct Material,
/// textures, `materialOf(Surface)`, the BSDFs, and functions that call the right one of them.
std::string materialText(const TraceKey& key);

/// The text of the trace kernel before its main function, followed by `main`. For tests that trace
/// their own rays.
std::string composeWith(const TraceKey& key, std::string_view main);

/// The embedded text of a file of shaders/; empty if there is none of that path.
std::string_view shaderText(std::string_view path);

/// Expands the first `#include` of each file, and removes later ones. `name` is the file name of
/// `text` in #line directives.
std::string expandIncludes(std::string_view text, const std::string& name);

}  // namespace laver
