#include "scene/reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/numbers.h"
#include "scene/suggest.h"
#include "scene/transform_reader.h"
#include "scene/user_text.h"

namespace laver::xml {
namespace {

const ObjectRule kScene{"scene", "", {}, nullptr};

/// Whether a tag holds, at any depth, what every picture needs.
bool holdsNeeded(pugi::xml_node node) {
  return static_cast<bool>(node.find_node([](pugi::xml_node child) {
    const TagRule* rule = findTag(child.name());
    return rule != nullptr && rule->need == Need::Always;
  }));
}

}  // namespace

void Reader::findIntegrator(pugi::xml_node root) {
  const char* type = root.child("integrator").attribute("type").value();
  if (draft_.overrides.integrator) {
    integrator_ = draft_.overrides.integrator;
  } else if (const IntegratorRow* row = rowCalled(integratorRows(), type)) {
    integrator_ = IntegratorUse{row};
  } else {
    integrator_ = userIntegrator(userFilePath(type));
  }
  draft_.integratorKnown = integrator_.has_value();
  if (integrator_) draft_.scene.integrator = *integrator_;
  if (!integrator_ && !root.child("integrator")) {
    diagnostics_.error(at(root), fmt::format("<scene> needs an <integrator>: expected type {}",
                                             expectedNames("", knownTypes("integrator"))));
  }
}

void Reader::readScene(pugi::xml_node root) {
  findIntegrator(root);
  checkAttributes(root, {}, source_, diagnostics_);
  checkDialect(root);
  hintAtDialect(root);
  Properties none(kScene, at(root), diagnostics_);
  readChildren(root, &none, "scene");
  if (!root.child("camera")) buildDefault("camera", knownTypes("camera").front(), at(root));
  if (!root.child("sampler")) {
    const SamplerRow* sampler = draft_.overrides.sampler;
    buildDefault("sampler", (sampler != nullptr ? sampler : draft_.scene.sampler.row)->name,
                 at(root));
  }
  auto& lights = draft_.scene.lights;
  lights.insert(lights.end(), draft_.meshLights.begin(), draft_.meshLights.end());
  std::erase_if(draft_.meshes, [](const MeshDraft& mesh) { return mesh.isSky; });
  checkAreaLights();
  if (draft_.overrides.dialect->emittersAbsorb)
    for (MeshDraft& mesh : draft_.meshes)
      if (mesh.light) mesh.bsdf = {.values = {{"albedo", glm::dvec3(0.0)}}};
}

void Reader::checkAreaLights() {
  const IntegratorRow& row = *draft_.scene.integrator.row;
  if (!row.needs.lights || row.needs.emitters) return;
  for (const MeshDraft& mesh : draft_.meshes)
    if (mesh.light)
      diagnostics_.error(mesh.lightOffset,
                         fmt::format("integrator \"{}\" uses point lights only", row.name));
}

void Reader::buildDefault(const char* tag, std::string_view type, std::size_t offset) {
  const ObjectRule& rule = *findObject(tag, type);
  rule.build(Properties(rule, offset, diagnostics_), "scene", draft_);
}

// A first pass reads the properties of an object, which is then built; a second pass reads the
// objects inside it.
void Reader::readChildren(pugi::xml_node node, Properties* properties, std::string_view parent) {
  for (const pugi::xml_node child : node.children()) {
    const std::string_view tag = child.name();
    if (!isElement(child)) {
      diagnostics_.error(at(child), fmt::format("text outside of tags in <{}>", node.name()));
    } else if (const PropertyType* type = findPropertyType(tag)) {
      readProperty(child, *type, *properties);
    } else if (findOperation(tag)) {
      diagnostics_.error(at(child), fmt::format("<{}> outside of a <transform>", tag));
    }
  }
  if (properties->rule().build) {
    properties->checkRequired();
    properties->rule().build(*properties, parent, draft_);
  }
  for (const pugi::xml_node child : node.children()) {
    if (!isElement(child) || findPropertyType(child.name()) || findOperation(child.name()))
      continue;
    if (const TagRule* rule = findTag(child.name())) {
      readObject(child, *rule, properties->rule());
    } else {
      readUnknownTag(child, properties->rule().tag);
    }
  }
}

void Reader::readProperty(pugi::xml_node node, PropertyType type, Properties& properties) {
  const bool transform = type == PropertyType::Transform;
  if (transform) {
    checkAttributes(node, {"name"}, source_, diagnostics_);
  } else {
    checkAttributes(node, {"name", "value"}, source_, diagnostics_);
    checkNoContent(node, source_, diagnostics_);
  }
  const ObjectRule& rule = properties.rule();
  const char* name = requireAttribute(node, "name", source_, diagnostics_);
  const bool complete = transform || requireAttribute(node, "value", source_, diagnostics_);
  if (!name || !complete) return;
  const std::size_t index = properties.find(name);
  if (index == rule.properties.size()) {
    std::vector<std::string_view> names;
    for (const PropertyRow& property : rule.properties) names.emplace_back(property.name);
    diagnostics_.warning(
        at(node), fmt::format("{} has no property {}: ignored; it takes {}", nameOf(rule),
                              inQuotes(name), names.empty() ? "none" : expectedNames(name, names)));
    return;
  }
  if (properties.wasGiven(index)) {
    diagnostics_.warning(
        at(node), fmt::format("the property \"{}\" is given twice; the last one is used", name));
  }
  if (auto value = readValue(node, type, rule.properties[index])) {
    properties.set(index, *std::move(value), at(node));
  } else {
    properties.spoil(index, at(node));
  }
}

std::optional<Value> Reader::readValue(pugi::xml_node node, PropertyType type,
                                       const PropertyRow& row) {
  const char* name = node.attribute("name").value();
  const PropertyType wanted = row.type;
  const bool integerForFloat = wanted == PropertyType::Float && type == PropertyType::Integer;
  const bool grey = wanted == PropertyType::Color && type == PropertyType::Float;
  const bool pair = row.pair && (type == PropertyType::Vector || type == PropertyType::Point);
  if (type != wanted && !integerForFloat && !grey && !pair) {
    diagnostics_.error(at(node), fmt::format("the property \"{}\" is a <{}>, expected a <{}>", name,
                                             tagOf(type), tagOf(wanted)));
    return std::nullopt;
  }
  if (type == PropertyType::Transform) {
    const auto matrix = readTransform(node, source_, *draft_.overrides.dialect, diagnostics_);
    return matrix ? std::optional<Value>(*matrix) : std::nullopt;
  }
  Value value;
  std::string text = node.attribute("value").value();
  if (pair && splitList(text).size() == 2) text += " 0";
  const std::string problem = parseValue(type, text, value);
  if (!problem.empty()) {
    diagnostics_.error(at(node), fmt::format("the property \"{}\": {}", name, problem));
    return std::nullopt;
  }
  if (grey) value = glm::dvec3(std::get<double>(value));
  if (integerForFloat) value = static_cast<double>(std::get<std::int64_t>(value));
  return value;
}

bool Reader::checkPlace(pugi::xml_node node, const TagRule& rule, std::string_view parent) {
  const std::string_view tag = rule.tag;
  const std::string parents = rule.parents;
  if (!parents.empty() && parents.find(std::string(parent) + " ") == std::string::npos) {
    diagnostics_.error(at(node), fmt::format("<{}> is in <{}>, expected in <{}>", tag, parent,
                                             parents.substr(0, parents.find(' '))));
    return false;
  }
  if (rule.many && (parent == "scene" || parents.empty())) return true;
  const pugi::xml_node first = node.parent().find_child(
      [&](pugi::xml_node sibling) { return findTag(sibling.name()) == &rule; });
  if (first == node) return true;
  diagnostics_.error(at(node), fmt::format("a second <{}> in <{}>, expected one: the first is in "
                                           "line {}",
                                           tag, parent, source_.line(at(first))));
  return false;
}

void Reader::missing(pugi::xml_node node, Need need, const std::string& message) {
  if (need == Need::Always || (need == Need::Shading && needsShading(draft_))) {
    diagnostics_.error(at(node), message);
  } else {
    const std::string who =
        integrator_ ? fmt::format("integrator \"{}\"", integrator_->row->name) : "the picture";
    diagnostics_.warning(at(node), fmt::format("{}; ignored, {} does not need it", message, who));
  }
}

// A texture replaces a colour or a float of the BSDF around it, or the radiance of an area light,
// or it is a normal map.
bool Reader::checkTexture(pugi::xml_node node, const ObjectRule& parent) {
  draft_.texturedLight = parent.type == std::string_view(emitters::area.name);
  if (parent.tag != std::string_view("bsdf") && !draft_.texturedLight) {
    missing(node, Need::Shading,
            fmt::format("<texture> is in {}, expected in <bsdf> or <emitter type=\"{}\">",
                        nameOf(parent), emitters::area.name));
    return false;
  }
  const std::string_view name = node.attribute("name").value();
  // Some courses name it after the property with "map" behind it.
  const std::string_view stem = name.ends_with("map") ? name.substr(0, name.size() - 3) : name;
  std::vector<std::string_view> names;
  std::string_view property;
  for (const PropertyRow& row : parent.properties) {
    if (row.type != PropertyType::Color &&
        (row.type != PropertyType::Float || draft_.texturedLight))
      continue;
    names.emplace_back(row.name);
    if (row.isCalled(name) || (property.empty() && row.isCalled(stem))) property = row.name;
  }
  if (!draft_.texturedLight) {
    if (property.empty() && (name == "normal" || name == "normalmap")) property = kNormalMap;
    names.emplace_back("normal");
  }
  if (property.empty()) {
    missing(node, Need::Shading,
            fmt::format("<texture> replaces {} of {}, expected name={}", inQuotes(name),
                        nameOf(parent), expectedNames(name, names)));
    return false;
  }
  for (const pugi::xml_node other : node.parent().children())
    if (other != node && name == other.attribute("name").value() &&
        (findPropertyType(other.name()) || other.offset_debug() < node.offset_debug()))
      diagnostics_.warning(at(node),
                           fmt::format("the property {} is given twice; {}", inQuotes(name),
                                       findPropertyType(other.name()) ? "the texture is used"
                                                                      : "the last one is used"));
  draft_.textured = property;
  return true;
}

void Reader::readObject(pugi::xml_node node, const TagRule& rule, const ObjectRule& parent) {
  if (!checkPlace(node, rule, parent.tag)) return;
  const char* type = requireAttribute(node, "type", source_, diagnostics_);
  if (!type) return;
  // All samplers have the same properties, including those that laver lacks.
  if (rule.tag == std::string_view("sampler") && draft_.overrides.sampler != nullptr)
    type = draft_.overrides.sampler->name;
  const ObjectRule* object = findObject(rule.tag, type);
  if (object) {
    checkAttributes(node, {"type", "name"}, source_, diagnostics_);
    if (rule.tag == std::string_view("texture") && !checkTexture(node, parent)) return;
    Properties properties(*object, at(node), diagnostics_);
    readChildren(node, &properties, parent.tag);
    return;
  }
  const bool integrator = rule.tag == std::string_view("integrator");
  const bool bsdf = rule.tag == std::string_view("bsdf");
  if (integrator && readUserIntegrator(node, type)) return;
  if (bsdf && readUserBsdf(node, type, parent)) return;
  const auto types = knownTypes(rule.tag);
  std::string known = types.empty() ? "it has none" : "expected " + expectedNames(type, types);
  if (const std::string file = userFileName(type); (integrator || bsdf) && !file.empty())
    known += fmt::format("; there is no file {} next to the scene either", file);
  const bool replaced = integrator && draft_.overrides.integrator;
  missing(node, replaced ? Need::Never : rule.need,
          fmt::format("laver has no {} of type {}: {}", rule.tag, inQuotes(type), known));
}

// A tag with a type is an object of somebody's dialect, unless it reads like one of laver's own. It
// may be geometry or a camera where those stand, or hold them.
void Reader::readUnknownTag(pugi::xml_node node, std::string_view parent) {
  const std::string_view tag = node.name();
  const std::string_view hint = nearest(tag, knownTags());
  const std::string message =
      fmt::format("unknown tag <{}>: {}", tag,
                  hint.empty() ? "expected " + expectedNames(tag, knownTags())
                               : fmt::format("the nearest is <{}>", hint));
  if (!node.attribute("type")) {
    diagnostics_.error(at(node), message);
    return;
  }
  const bool geometry = parent == "scene" || parent == "camera" || holdsNeeded(node);
  const TagRule* meant = findTag(hint);
  missing(node, meant ? meant->need : geometry ? Need::Always : Need::Shading, message);
}

}  // namespace laver::xml
