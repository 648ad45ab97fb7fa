#include "scene/bsdfs.h"

#include <filesystem>
#include <utility>

#include "scene/user_text.h"

namespace laver {

std::shared_ptr<UserBsdf> userBsdf(const std::string& file) {
  std::optional<std::string> text = userText(file);
  if (!text) return nullptr;
  auto user = std::make_shared<UserBsdf>();
  user->name = std::filesystem::path(file).stem().string();
  user->file = file;
  user->text = std::move(*text);
  user->row.name = user->row.object = user->name.c_str();
  return user;
}

const Texture* Bsdf::texture(std::string_view property) const {
  for (const NamedTexture& named : textures)
    if (named.property == property) return &named.texture;
  return nullptr;
}

Texture* Bsdf::texture(std::string_view property) {
  return const_cast<Texture*>(std::as_const(*this).texture(property));
}

void Bsdf::show(std::string_view property, Texture shown) {
  if (Texture* before = texture(property))
    *before = std::move(shown);
  else
    textures.push_back({std::string(property), std::move(shown)});
}

bool usesTangent(const Bsdf& bsdf) {
  const char* name = bsdf.row->anisotropy;
  return name != nullptr && (bsdf.texture(name) != nullptr || bsdf.real(name) != 0.0);
}

std::vector<const PropertyRow*> propertiesOf(const BsdfRow& row, PropertyType type) {
  std::vector<const PropertyRow*> found;
  for (const PropertyRow& property : row.properties)
    if (property.type == type) found.push_back(&property);
  return found;
}

const PropertyRow* albedoOf(const BsdfRow& row) {
  for (const PropertyRow& property : row.properties)
    if (property.type == PropertyType::Color) return &property;
  return nullptr;
}

std::vector<glm::dvec3> colorsOf(const Bsdf& bsdf) {
  std::vector<glm::dvec3> colors;
  for (const PropertyRow* property : propertiesOf(*bsdf.row, PropertyType::Color))
    colors.push_back(bsdf.color(property->name));
  return colors;
}

std::vector<double> numbersOf(const Bsdf& bsdf) {
  std::vector<double> numbers;
  for (const PropertyRow* property : propertiesOf(*bsdf.row, PropertyType::Float))
    numbers.push_back(bsdf.real(property->name));
  return numbers;
}

}  // namespace laver
