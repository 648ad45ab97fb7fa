#include "render/materials.h"

#include <algorithm>

namespace laver {

std::string bsdfName(const Mesh& mesh) { return mesh.bsdf.row->name; }

std::string textureName(const Texture& texture) { return texture.row->name; }

const std::vector<std::string>& allTextureNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const TextureRow* row : textureRows()) all.emplace_back(row->name);
    std::sort(all.begin(), all.end());
    return all;
  }();
  return names;
}

bool isVisible(const std::optional<Texture>& texture) {
  return texture && (!texture->row->picture || texture->image);
}

bool hasNumbers(const Mesh& mesh) { return !numbersOf(mesh.bsdf).empty(); }

bool sameMaterial(const Mesh& a, const Mesh& b) {
  return a.bsdf.row == b.bsdf.row && a.bsdf.albedo == b.bsdf.albedo &&
         numbersOf(a.bsdf) == numbersOf(b.bsdf);
}

glm::dvec3 albedoOf(const Mesh& mesh) { return mesh.bsdf.albedo; }

shared::Material materialOf(const Mesh& mesh, const std::vector<std::string>& bsdfs) {
  const auto index = std::find(bsdfs.begin(), bsdfs.end(), bsdfName(mesh)) - bsdfs.begin();
  glm::vec4 numbers(0.0F);
  int i = 0;
  for (const double number : numbersOf(mesh.bsdf)) numbers[i++] = static_cast<float>(number);
  return {glm::vec3(albedoOf(mesh)), static_cast<std::uint32_t>(index), numbers};
}

}  // namespace laver
