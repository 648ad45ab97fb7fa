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

/// A property's value; vectors, points and colours are three numbers.
using Value = std::variant<std::string, bool, double, std::int64_t, glm::dvec3, glm::dmat4>;

/// A value as a scene would write it: of a transform, which is no attribute, "".
std::string textOf(const Value& value);

/// The numbers that a property accepts: min < x < max or, if `closed`, min <= x <= max.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool closed = false;

  bool holds(double x) const { return closed ? x >= min && x <= max : x > min && x < max; }
};
constexpr Range moreThan(double min) { return {.min = min}; }
constexpr Range between(double min, double max) { return {.min = min, .max = max}; }
constexpr Range fromTo(double min, double max) { return {.min = min, .max = max, .closed = true}; }

/// A property that an object of a scene file takes.
struct PropertyRow {
  const char* name;
  PropertyType type;
  Value start{};          ///< the default, or what stands where a required property is missing
  bool required = false;  ///< in scenes
  Range range{};          ///< of a Float or an Integer; any number that is finite if not said
  const char* unit = "";  ///< such as "pixels"
  const char* meaning = "";
};

/// What is wrong with a number, for messages: "fov must be more than 0 and less than 180 degrees,
/// found 190"; empty if nothing is.
std::string problemOf(const PropertyRow& row, const Value& number);
/// The range in words with its unit, such as "1 to 10 pixels"; empty if any number serves.
std::string rangeText(const PropertyRow& row);

/// A property that a scene sets.
struct NamedValue {
  std::string name;
  Value value;
};
using Values = std::vector<NamedValue>;

/// The property's value in `given`, or else its row's start. The row must be there.
const Value& valueOf(const std::vector<PropertyRow>& rows, const Values& given,
                     std::string_view name);
void setValue(Values& values, std::string_view name, Value value);

}  // namespace laver
