#include "scene/property.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace laver {
namespace {

template <class T>
std::string text(const T& value) {
  if constexpr (std::is_same_v<T, glm::dmat4>) {
    return "";
  } else if constexpr (std::is_same_v<T, glm::dvec3>) {
    return fmt::format("{} {} {}", value.x, value.y, value.z);
  } else {
    return fmt::format("{}", value);
  }
}

}  // namespace

std::string textOf(const Value& value) {
  return std::visit([](const auto& v) { return text(v); }, value);
}

std::string rangeText(const PropertyRow& row) {
  const Range& range = row.range;
  const std::string unit = *row.unit == '\0' ? "" : std::string(" ") + row.unit;
  if (range.min == range.max) return fmt::format("{}{}", range.min, unit);
  if (range.closed && std::isinf(range.max)) return fmt::format("at least {}", range.min);
  if (range.closed) return fmt::format("{:.0f} to {:.0f}{}", range.min, range.max, unit);
  if (std::isinf(range.min)) return "";
  // 0 needs no unit.
  if (std::isinf(range.max)) return fmt::format("more than {}", range.min);
  return fmt::format("more than {} and less than {}{}", range.min, range.max, unit);
}

std::string problemOf(const PropertyRow& row, const Value& value) {
  const auto contains = [&](double x) { return row.range.contains(x); };
  const auto* integer = std::get_if<std::int64_t>(&value);
  const auto* color = std::get_if<glm::dvec3>(&value);
  const bool valid = integer != nullptr ? contains(static_cast<double>(*integer))
                     : color != nullptr
                         ? contains(color->x) && contains(color->y) && contains(color->z)
                         : contains(std::get<double>(value));
  if (valid) return {};
  return fmt::format("{} must be {}, found {}", row.name, rangeText(row), textOf(value));
}

const Value& valueOf(const std::vector<PropertyRow>& rows, const Values& given,
                     std::string_view name) {
  for (const NamedValue& value : given)
    if (value.name == name) return value.value;
  for (const PropertyRow& row : rows)
    if (row.name == name) return row.start;
  throw std::out_of_range(fmt::format("no property {}", name));
}

void setValue(Values& values, std::string_view name, Value value) {
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const NamedValue& v) { return v.name == name; });
  if (found != values.end())
    found->value = std::move(value);
  else
    values.push_back({std::string(name), std::move(value)});
}

}  // namespace laver
