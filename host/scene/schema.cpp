#include "scene/schema.h"

#include <algorithm>
#include <array>

namespace laver::xml {
namespace {

constexpr std::array kTags = {
    TagRule{"integrator", Need::Always, "scene ", false},
    TagRule{"camera", Need::Always, "scene ", false},
    TagRule{"sampler", Need::Always, "scene ", false},
    TagRule{"rfilter", Need::Always, "camera ", false},
    TagRule{"mesh", Need::Always, "scene ", true},
    TagRule{"bsdf", Need::Shading, "mesh ", false},
    TagRule{"emitter", Need::Shading, "scene mesh ", true},
    TagRule{"texture", Need::Shading, "", true},
    TagRule{"medium", Need::Never, "", true},
    TagRule{"phase", Need::Never, "", true},
    TagRule{"test", Need::Never, "", true},
};

constexpr std::array kPropertyTypes = {
    PropertyType::String, PropertyType::Boolean, PropertyType::Float, PropertyType::Integer,
    PropertyType::Vector, PropertyType::Point,   PropertyType::Color, PropertyType::Transform};

constexpr std::array<std::string_view, 5> kOperations = {"translate", "scale", "rotate", "matrix",
                                                         "lookat"};

}  // namespace

std::span<const TagRule> tagRules() { return kTags; }

std::span<const std::string_view> transformOperations() { return kOperations; }

bool isOperation(std::string_view tag) {
  return std::find(kOperations.begin(), kOperations.end(), tag) != kOperations.end();
}

const TagRule* findTag(std::string_view tag) {
  const auto rule = std::find_if(kTags.begin(), kTags.end(),
                                 [&](const TagRule& candidate) { return candidate.tag == tag; });
  return rule == kTags.end() ? nullptr : &*rule;
}

const ObjectRule* findObject(std::string_view tag, std::string_view type) {
  for (const ObjectRule& rule : objectRules()) {
    if (rule.tag == tag && rule.type == type) return &rule;
  }
  return nullptr;
}

const PropertyType* findPropertyType(std::string_view tag) {
  for (const PropertyType& type : kPropertyTypes) {
    if (tagOf(type) == tag) return &type;
  }
  return nullptr;
}

std::vector<std::string_view> knownTypes(std::string_view tag) {
  std::vector<std::string_view> types;
  for (const ObjectRule& rule : objectRules()) {
    if (rule.tag == tag) types.emplace_back(rule.type);
  }
  return types;
}

std::vector<std::string_view> knownTags() {
  std::vector<std::string_view> tags;
  tags.reserve(kTags.size() + kPropertyTypes.size() + kOperations.size());
  for (const TagRule& rule : kTags) tags.emplace_back(rule.tag);
  for (const PropertyType type : kPropertyTypes) tags.emplace_back(tagOf(type));
  tags.insert(tags.end(), kOperations.begin(), kOperations.end());
  return tags;
}

bool shades(Integrator integrator) {
  return integrator == Integrator::DirectWhitted || integrator == Integrator::Albedo;
}

}  // namespace laver::xml
