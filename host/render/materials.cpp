#include "render/materials.h"

#include <algorithm>

namespace laver {

std::string bsdfName(const Mesh&) { return "diffuse"; }

std::string textureName(const Texture& texture) {
  return texture.kind == Texture::Kind::Checker ? "checker" : "bitmap";
}

const std::vector<std::string>& allTextureNames() {
  static const std::vector<std::string> names = {"bitmap", "checker"};
  return names;
}

bool shows(const std::optional<Texture>& texture) {
  return texture && (texture->kind == Texture::Kind::Checker || texture->image);
}

bool hasNumbers(const Mesh&) { return false; }

bool alike(const Mesh& a, const Mesh& b) { return a.bsdf.albedo == b.bsdf.albedo; }

glm::dvec3 albedoOf(const Mesh& mesh) { return mesh.bsdf.albedo; }

shared::Material materialOf(const Mesh& mesh, const std::vector<std::string>& bsdfs) {
  const auto place = std::find(bsdfs.begin(), bsdfs.end(), bsdfName(mesh)) - bsdfs.begin();
  return {glm::vec3(albedoOf(mesh)), static_cast<std::uint32_t>(place), glm::vec4(0.0F)};
}

}  // namespace laver
