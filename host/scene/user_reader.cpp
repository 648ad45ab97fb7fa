// Integrators and BSDFs from users' files: GLSL in TYPE.glsl next to the scene.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "scene/reader.h"
#include "scene/user_text.h"

namespace laver::xml {
/// The path of TYPE.glsl next to the scene, which need not exist; empty if the type cannot be a
/// file name.
std::string Reader::userFilePath(std::string_view type) const {
  const std::string name = userFileName(type);
  if (name.empty()) return {};
  return (std::filesystem::path(source_.file()).parent_path() / name).string();
}

// If there is a file TYPE.glsl next to the scene, it is an integrator with any properties.
bool Reader::readUserIntegrator(pugi::xml_node node, const char* type) {
  std::optional<IntegratorUse> use = userIntegrator(userFilePath(type));
  if (!use) return false;
  for (const pugi::xml_node child : node.children()) {
    if (!isElement(child)) continue;
    const PropertyType* property = findPropertyType(child.name());
    const std::string name = child.attribute("name").value();
    if (property == nullptr || *property == PropertyType::String ||
        *property == PropertyType::Transform || !isGlslName(name)) {
      diagnostics_.error(
          at(child), fmt::format("{} takes numbers, booleans, points, vectors and colours whose "
                                 "names are letters, digits and _",
                                 inQuotes(use->user->file)));
      continue;
    }
    if (const auto value = readValue(child, *property, {.name = "", .type = *property}))
      setValue(use->values, name, *value);
  }
  takeIntegrator(*use, draft_);
  return true;
}

// If there is a file TYPE.glsl next to the scene, it is a BSDF with any colours and floats.
bool Reader::readUserBsdf(pugi::xml_node node, const char* type, const ObjectRule& parent) {
  const std::string file = userFilePath(type);
  std::shared_ptr<UserBsdf>& user = draft_.userBsdfs[file];
  if (!user) user = userBsdf(file);
  if (!user) return false;
  addProperties(node, *user);
  const ObjectRule rule{"bsdf", user->row.name, user->row.properties,
                        [user](const Properties& given, std::string_view, Draft& draft) {
                          takeBsdf(user->row, user, given, draft);
                        }};
  checkAttributes(node, {"type", "name"}, source_, diagnostics_);
  Properties properties(rule, at(node), diagnostics_);
  readChildren(node, &properties, parent.tag);
  return true;
}

/// Adds the properties that a mesh sets to those of a user's BSDF. A texture replaces a colour,
/// unless another mesh gives a float of that name.
void Reader::addProperties(pugi::xml_node node, UserBsdf& user) {
  std::vector<PropertyRow>& rows = user.row.properties;
  for (const pugi::xml_node child : node.children()) {
    const PropertyType* property = findPropertyType(child.name());
    const bool color = child.name() == std::string_view("texture") ||
                       (property != nullptr && *property == PropertyType::Color);
    const std::string name = child.attribute("name").value();
    if (!color && property == nullptr) continue;
    if (std::any_of(rows.begin(), rows.end(), [&](const auto& row) { return row.name == name; }))
      continue;
    const bool number = property != nullptr &&
                        (*property == PropertyType::Float || *property == PropertyType::Integer);
    if (!isGlslName(name) || !(color || number)) {
      diagnostics_.error(at(child), fmt::format("{} takes colours and floats whose names are "
                                                "letters, digits and _",
                                                inQuotes(user.file)));
      continue;
    }
    if (rows.size() == kMostBsdfProperties) {
      diagnostics_.error(at(child), fmt::format("{} takes {} properties at most",
                                                inQuotes(user.file), kMostBsdfProperties));
      continue;
    }
    const Value start = color ? Value(glm::dvec3(1.0)) : Value(0.0);
    rows.push_back({.name = user.names.emplace_back(name).c_str(),
                    .type = color ? PropertyType::Color : PropertyType::Float,
                    .start = start});
  }
}

}  // namespace laver::xml
