#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace laver {

/// The property tags of a scene file.
enum class PropertyType { String, Boolean, Float, Integer, Vector, Point, Color, Transform };

/// Whether its values are three numbers.
constexpr bool isTriple(PropertyType type) {
  return type == PropertyType::Vector || type == PropertyType::Point || type == PropertyType::Color;
}

/// A property's value; vectors, points and colours are three numbers.
using Value = std::variant<std::string, bool, double, std::int64_t, glm::dvec3, glm::dmat4>;

/// A value as text in a scene; "" for a transform, which is not an attribute.
std::string textOf(const Value& value);

/// The numbers that a property accepts: min < x < max or, if `closed`, min <= x <= max.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool closed = false;

  bool contains(double x) const { return closed ? x >= min && x <= max : x > min && x < max; }
};
constexpr Range moreThan(double min) { return {.min = min}; }
constexpr Range atLeast(double min) { return {.min = min, .closed = true}; }
constexpr Range between(double min, double max) { return {.min = min, .max = max}; }
constexpr Range fromTo(double min, double max) { return {.min = min, .max = max, .closed = true}; }

/// The unit of lengths in a scene.
inline constexpr const char* kSceneUnits = "scene units";
/// The unit of lengths that are fractions of the diagonal of the scene's bounding box.
inline constexpr const char* kDiagonals = "diagonals of the scene";
/// The unit of what falls with the squared distance in scene units.
inline constexpr const char* kPowers = "W";

/// A property that an object of a scene file takes.
struct PropertyRow {
  const char* name;
  PropertyType type;
  Value start{};          ///< the default; also stands for a missing required property
  bool required = false;  ///< in scenes
  Range range{};          ///< of a number or of each of a colour's; default: any finite one
  const char* unit = "";  ///< for example "pixels"
  const char* meaning = "";
  bool pair = false;          ///< a Vector or a Point of two numbers; a third is ignored
  const char* spelling = "";  ///< another name in scenes

  bool isCalled(std::string_view given) const {
    return given == name || (given == spelling && *spelling != '\0');
  }
};

/// The problem with a number or a colour, for messages: "fov must be more than 0 and less than 180
/// degrees, found 190"; empty if there is none.
std::string problemOf(const PropertyRow& row, const Value& value);
/// The range as text with its unit, for example "1 to 10 pixels"; empty if any number is valid.
std::string rangeText(const PropertyRow& row);

/// A property that a scene sets.
struct NamedValue {
  std::string name;
  Value value;
};
using Values = std::vector<NamedValue>;

/// The property's value in `given`, or else its default. The row must exist.
const Value& valueOf(const std::vector<PropertyRow>& rows, const Values& given,
                     std::string_view name);
void setValue(Values& values, std::string_view name, Value value);

}  // namespace laver
