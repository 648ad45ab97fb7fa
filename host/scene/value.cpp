#include "scene/value.h"

#include <fmt/format.h>

#include "scene/numbers.h"
#include "scene/text_source.h"

namespace laver::xml {
namespace {

template <class T>
std::string take(std::string_view text, const Parsed<T>& parsed, const char* wanted, Value& value) {
  if (!parsed) return fmt::format("{} {}, expected {}", inQuotes(text), parsed.problem, wanted);
  value = parsed.value;
  return {};
}

std::string parseBoolean(std::string_view text, Value& value) {
  std::string lower(text.substr(0, 8));
  for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (lower != "true" && lower != "false") {
    return fmt::format("{} is not a boolean, expected true or false", inQuotes(text));
  }
  value = lower == "true";
  return {};
}

}  // namespace

const char* tagOf(PropertyType type) {
  switch (type) {
    case PropertyType::String:
      return "string";
    case PropertyType::Boolean:
      return "boolean";
    case PropertyType::Float:
      return "float";
    case PropertyType::Integer:
      return "integer";
    case PropertyType::Vector:
      return "vector";
    case PropertyType::Point:
      return "point";
    case PropertyType::Color:
      return "color";
    case PropertyType::Transform:
      return "transform";
  }
  return "";
}

std::string parseNumbers(std::string_view text, std::size_t count, double* numbers) {
  const auto pieces = splitList(text);
  if (pieces.size() != count) {
    return fmt::format("expected {} number{}, found {} in {}", count, count == 1 ? "" : "s",
                       pieces.size(), inQuotes(text));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = parseReal(pieces[i]);
    if (!number) {
      return fmt::format("{} {}, expected {} number{}", inQuotes(pieces[i]), number.problem, count,
                         count == 1 ? "" : "s");
    }
    numbers[i] = number.value;
  }
  return {};
}

std::string parseValue(PropertyType type, std::string_view text, Value& value) {
  switch (type) {
    case PropertyType::String:
      value = std::string(text);
      return {};
    case PropertyType::Boolean:
      return parseBoolean(trimmed(text), value);
    case PropertyType::Float:
      return take(text, parseReal(trimmed(text)), "a number", value);
    case PropertyType::Integer:
      return take(text, parseInteger(trimmed(text)), "an integer", value);
    case PropertyType::Vector:
    case PropertyType::Point:
    case PropertyType::Color: {
      double v[3];
      std::string problem = parseNumbers(text, 3, v);
      if (problem.empty()) value = glm::dvec3(v[0], v[1], v[2]);
      return problem;
    }
    case PropertyType::Transform:
      break;
  }
  return "expected operations such as <translate>, not a value";
}

}  // namespace laver::xml
