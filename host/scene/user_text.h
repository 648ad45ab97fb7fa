#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace laver {

/// The GLSL text of a user's own file; nothing where it cannot be read.
std::optional<std::string> userText(const std::string& file);

/// The name of the file that a type may stand for, TYPE.glsl beside the scene; empty where the type
/// is no name that GLSL has.
std::string userFileName(std::string_view type);

/// Whether a part of a name in GLSL can be so: letters, digits and _.
bool isGlslName(std::string_view name);

}  // namespace laver
