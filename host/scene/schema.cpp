#include "scene/schema.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace laver::xml {
namespace {

constexpr std::array kTags = {
    TagRule{"integrator", Need::Always, "scene ", false},
    TagRule{"camera", Need::Always, "scene ", false},
    TagRule{"sampler", Need::Always, "scene ", false},
    TagRule{"rfilter", Need::Always, "camera ", false},
    TagRule{"mesh", Need::Always, "scene ", true, "shape"},
    TagRule{"bsdf", Need::Shading, "mesh ", false},
    TagRule{"emitter", Need::Shading, "scene mesh ", true, "luminaire"},
    TagRule{"texture", Need::Shading, "", true},
    TagRule{"medium", Need::Never, "", true},
    TagRule{"phase", Need::Never, "", true},
    TagRule{"test", Need::Never, "", true},
};

constexpr std::array kPropertyTypes = {
    PropertyType::String, PropertyType::Boolean, PropertyType::Float, PropertyType::Integer,
    PropertyType::Vector, PropertyType::Point,   PropertyType::Color, PropertyType::Transform};

constexpr std::array kValue3 = {OperationAttribute{"value", 3}};
constexpr std::array kValue16 = {OperationAttribute{"value", 16}};
constexpr std::array kRotate = {OperationAttribute{"axis", 3}, OperationAttribute{"angle", 1}};
constexpr std::array kLookAt = {OperationAttribute{"target", 3}, OperationAttribute{"origin", 3},
                                OperationAttribute{"up", 3}};
constexpr std::array kOperations = {
    OperationRule{"translate", kValue3}, OperationRule{"scale", kValue3},
    OperationRule{"rotate", kRotate}, OperationRule{"matrix", kValue16},
    OperationRule{"lookat", kLookAt}};

}  // namespace

std::span<const TagRule> tagRules() { return kTags; }

std::span<const OperationRule> operationRules() { return kOperations; }

const OperationRule* findOperation(std::string_view tag) {
  const auto rule = std::find_if(kOperations.begin(), kOperations.end(),
                                 [&](const OperationRule& o) { return o.tag == tag; });
  return rule == kOperations.end() ? nullptr : &*rule;
}

const TagRule* findTag(std::string_view tag) {
  const auto rule = std::find_if(kTags.begin(), kTags.end(), [&](const TagRule& candidate) {
    return candidate.tag == tag || (!tag.empty() && candidate.spelling == tag);
  });
  return rule == kTags.end() ? nullptr : &*rule;
}

const ObjectRule* findObject(std::string_view tag, std::string_view type) {
  for (const ObjectRule& rule : objectRules()) {
    if (rule.tag == tag && rule.type == type) return &rule;
  }
  return nullptr;
}

std::span<const PropertyType> propertyTypes() { return kPropertyTypes; }

const PropertyType* findPropertyType(std::string_view tag) {
  for (const PropertyType& type : kPropertyTypes) {
    if (tagOf(type) == tag) return &type;
  }
  return nullptr;
}

std::vector<std::string_view> knownTypes(std::string_view tag) {
  std::vector<std::string_view> types;
  for (const ObjectRule& rule : objectRules()) {
    if (rule.tag == tag && !rule.spelling) types.emplace_back(rule.type);
  }
  return types;
}

std::vector<std::string_view> knownOperations() {
  std::vector<std::string_view> tags;
  tags.reserve(std::size(kOperations));
  for (const OperationRule& rule : kOperations) tags.emplace_back(rule.tag);
  return tags;
}

std::vector<std::string_view> knownTags() {
  std::vector<std::string_view> tags;
  tags.reserve(kTags.size() + kPropertyTypes.size() + kOperations.size());
  for (const TagRule& rule : kTags) tags.emplace_back(rule.tag);
  for (const PropertyType type : kPropertyTypes) tags.emplace_back(tagOf(type));
  for (const OperationRule& rule : kOperations) tags.emplace_back(rule.tag);
  return tags;
}

bool needsShading(const Draft& draft) {
  return draft.overrides.shading || !draft.integratorKnown || shades(*draft.scene.integrator.row);
}

}  // namespace laver::xml
