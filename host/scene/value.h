#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <variant>

namespace laver::xml {

/// The property tags of a scene file.
enum class PropertyType { String, Boolean, Float, Integer, Vector, Point, Color, Transform };

/// The tag of a type, as in the file.
const char* tagOf(PropertyType type);

/// A property's value; vectors, points and colours are three numbers.
using Value = std::variant<std::string, bool, double, std::int64_t, glm::dvec3, glm::dmat4>;

/// Reads a value of any type but Transform. Returns what is wrong with the text, for a message such
/// as `property "fov": "abc" is not a number`; empty if nothing is.
std::string parseValue(PropertyType type, std::string_view text, Value& value);

/// Reads exactly `count` numbers separated by white space or commas; returns what is wrong.
std::string parseNumbers(std::string_view text, std::size_t count, double* numbers);

}  // namespace laver::xml
