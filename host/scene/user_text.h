#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace laver {

/// The GLSL text of a user's file; nothing if it cannot be read.
std::optional<std::string> userText(const std::string& file);

/// The file name of a user's type, TYPE.glsl; empty if the type is not a valid name in GLSL.
std::string userFileName(std::string_view type);

/// Whether a name can be part of a GLSL identifier: letters, digits and _.
bool isGlslName(std::string_view name);

}  // namespace laver
