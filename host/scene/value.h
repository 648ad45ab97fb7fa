#pragma once
#include <string>
#include <string_view>

#include "scene/property.h"

namespace laver::xml {

/// The tag of a type, as in the file.
const char* tagOf(PropertyType type);

/// Reads a value of any type but Transform. Returns what is wrong with the text, for a message such
/// as `property "fov": "abc" is not a number`; empty if nothing is.
std::string parseValue(PropertyType type, std::string_view text, Value& value);

/// Reads exactly `count` numbers separated by white space or commas; returns what is wrong.
std::string parseNumbers(std::string_view text, std::size_t count, double* numbers);

}  // namespace laver::xml
