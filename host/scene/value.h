#pragma once
#include <string>
#include <string_view>

#include "scene/property.h"

namespace laver::xml {

/// The tag of a type in scene files.
const char* tagOf(PropertyType type);

/// Reads a value of any type except Transform. Returns the problem with the text, for a message
/// such as `property "fov": "abc" is not a number`; empty if there is none.
std::string parseValue(PropertyType type, std::string_view text, Value& value);

/// Reads exactly `count` numbers separated by white space or commas; returns the problem, if any.
std::string parseNumbers(std::string_view text, std::size_t count, double* numbers);

}  // namespace laver::xml
