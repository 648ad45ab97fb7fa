#include "scene/properties.h"

#include <fmt/format.h>

namespace laver::xml {

std::string nameOf(const ObjectRule& rule) {
  if (*rule.type == '\0') return fmt::format("<{}>", rule.tag);
  return fmt::format("{} \"{}\"", rule.tag, rule.type);
}

Properties::Properties(const ObjectRule& rule, std::size_t offset, Diagnostics& diagnostics)
    : rule_(rule), offset_(offset), diagnostics_(diagnostics) {
  for (const PropertyRow& property : rule.properties)
    slots_.push_back({property.start, offset, false, !property.required});
}

std::size_t Properties::find(std::string_view name) const {
  std::size_t index = 0;
  while (index < rule_.properties.size() && !rule_.properties[index].isCalled(name)) ++index;
  return index;
}

void Properties::set(std::size_t index, Value value, std::size_t offset) {
  slots_[index] = {std::move(value), offset, true, true};
}

void Properties::spoil(std::size_t index, std::size_t offset) {
  slots_[index].given = true;
  slots_[index].offset = offset;
}

void Properties::checkRequired() const {
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const PropertyRow& property = rule_.properties[i];
    if (!property.required || slots_[i].given) continue;
    diagnostics_.error(offset_, fmt::format("{} needs the property <{} name=\"{}\">", nameOf(rule_),
                                            tagOf(property.type), property.name));
  }
}

double Properties::real(std::string_view name) const {
  checkRange(name, slot(name).value);
  return std::get<double>(slot(name).value);
}

std::int64_t Properties::integer(std::string_view name,
                                 const std::optional<std::int64_t>& instead) const {
  const Value value = instead ? Value(*instead) : slot(name).value;
  if (checkRange(name, value)) return std::get<std::int64_t>(value);
  return std::get<std::int64_t>(rule_.properties[find(name)].start);
}

bool Properties::checkRange(std::string_view name, const Value& value) const {
  const std::string problem = problemOf(rule_.properties[find(name)], value);
  if (!problem.empty()) error(name, problem);
  return problem.empty();
}

bool Properties::boolean(std::string_view name) const { return std::get<bool>(slot(name).value); }

glm::dvec3 Properties::triple(std::string_view name) const {
  return std::get<glm::dvec3>(slot(name).value);
}

glm::dmat4 Properties::transform(std::string_view name) const {
  return std::get<glm::dmat4>(slot(name).value);
}

const std::string& Properties::text(std::string_view name) const {
  return std::get<std::string>(slot(name).value);
}

Values Properties::values() const {
  Values values;
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const PropertyRow& row = rule_.properties[i];
    if (!slots_[i].given || !slots_[i].usable) continue;
    if (row.type == PropertyType::Float || row.type == PropertyType::Integer ||
        row.type == PropertyType::Color)
      checkRange(row.name, slots_[i].value);
    values.push_back({row.name, slots_[i].value});
  }
  return values;
}

bool Properties::has(std::string_view name) const { return slot(name).usable; }

void Properties::error(std::string_view name, const std::string& message) const {
  diagnostics_.error(slot(name).offset, message);
}

void Properties::note(const std::string& message) const { diagnostics_.warning(offset_, message); }

void Properties::warning(std::string_view name, const std::string& message) const {
  diagnostics_.warning(slot(name).offset, message);
}

}  // namespace laver::xml
