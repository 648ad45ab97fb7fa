#include "render/texture_data.h"

#include <algorithm>
#include <cmath>

namespace laver {
namespace {

using glm::dvec3;
using glm::vec2;
using glm::vec3;

/// An image that was not read shows white.
std::uint32_t kindOf(const std::optional<Texture>& texture) {
  if (!texture) return shared::TEXTURE_NONE;
  if (texture->kind == Texture::Kind::Checker) return shared::TEXTURE_CHECKER;
  return texture->image ? shared::TEXTURE_IMAGE : shared::TEXTURE_NONE;
}

std::uint32_t imagesOf(const std::shared_ptr<const Picture>& picture) {
  if (!picture) return 0;
  return std::holds_alternative<Bitmap>(*picture) ? shared::IMAGES_BYTES : shared::IMAGES_FLOATS;
}

}  // namespace

void TexturePacker::addMaterial(const Mesh& mesh, std::uint32_t firstId) {
  shared::Texture record{};
  record.kind = kindOf(mesh.bsdf.texture);
  record.color1 = vec3(mesh.bsdf.albedo);
  if (const auto& texture = mesh.bsdf.texture) {
    record.color1 = vec3(texture->colors[0]);
    record.color2 = vec3(texture->colors[1]);
    record.scale = vec2(texture->scale);
    record.offset = vec2(texture->offset);
    if (record.kind == shared::TEXTURE_IMAGE) record.picture = add(*texture->image, texture->raw);
  }
  record.uvs = static_cast<std::uint32_t>(data_.uvs.size() / 3) - firstId;
  data_.textures.push_back(record);
}

void TexturePacker::addTriangle(const Mesh& mesh, glm::uvec3 given, glm::uvec3 stored) {
  if (data_.textures.back().kind == shared::TEXTURE_NONE) return;
  for (int corner = 0; corner < 3; ++corner) {
    const std::uint32_t vertex = stored[corner];
    // Without coordinates u and v are the weights of the second and the third corner.
    data_.uvs.push_back(!mesh.uvs.empty() ? vec2(mesh.uvs[vertex])
                                          : vec2(vertex == given.y, vertex == given.z));
  }
}

void TexturePacker::packBackground(const Environment& environment) {
  // Only directions count; entries of about 1 keep them far from the range of floats.
  glm::dmat3 inverse = glm::inverse(glm::dmat3(environment.toWorld));
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(inverse[column][row]));
  inverse /= largest;
  for (int row = 0; row < 3; ++row)
    data_.params.background[row] = {inverse[0][row], inverse[1][row], inverse[2][row],
                                    environment.radiance[row]};
  if (environment.image) data_.params.backgroundPicture = add(*environment.image, environment.raw);
}

std::uint32_t TexturePacker::tableOf(bool raw) {
  const auto [entry, added] = tables_.emplace(raw, static_cast<std::uint32_t>(data_.images.size()));
  for (int i = 0; added && i < 256; ++i) {
    const double x = i / 255.0;
    data_.images.push_back(shared::floatBitsToUint(static_cast<float>(raw ? x : linearOfSrgb(x))));
  }
  return entry->second;
}

shared::Picture TexturePacker::add(const Picture& picture, bool raw) {
  const auto* bitmap = std::get_if<Bitmap>(&picture);
  const std::uint32_t table = bitmap != nullptr ? tableOf(raw) : shared::NO_TABLE;
  std::vector<std::uint32_t>& words = data_.images;
  const auto [entry, added] = pictures_.emplace(&picture, static_cast<std::uint32_t>(words.size()));
  if (added && bitmap != nullptr) {
    for (const Rgb8& p : bitmap->pixels)
      words.push_back(static_cast<std::uint32_t>(p[0] | p[1] << 8 | p[2] << 16));
  } else if (added) {
    for (const float value : std::get<Image>(picture).pixels)
      words.push_back(shared::floatBitsToUint(value));
  }
  return {entry->second, static_cast<std::uint32_t>(widthOf(picture)),
          static_cast<std::uint32_t>(heightOf(picture)), table};
}

void specialiseTextures(const Scene& scene, const IntegratorRow& shown, SpecConstants& constants) {
  std::uint32_t textures = 0, images = 0, background = shared::BACKGROUND_BLACK;
  // Without a light nothing that is hit shows.
  if (shown.needs.materials && (!shown.needs.lights || !scene.lights.empty()))
    for (const Mesh& mesh : scene.meshes) {
      const std::uint32_t kind = kindOf(mesh.bsdf.texture);
      if (kind == shared::TEXTURE_CHECKER) textures |= shared::TEXTURES_CHECKER;
      if (kind != shared::TEXTURE_IMAGE) continue;
      textures |= shared::TEXTURES_IMAGE;
      images |= imagesOf(mesh.bsdf.texture->image);
    }
  if (shown.needs.background && scene.environment) {
    const auto& sky = scene.environment;
    background = sky->image ? shared::BACKGROUND_IMAGE : shared::BACKGROUND_CONSTANT;
    images |= imagesOf(sky->image);
  }
  constants[shared::SPEC_TEXTURES] = textures;
  constants[shared::SPEC_IMAGES] = images;
  constants[shared::SPEC_BACKGROUND] = background;
}

}  // namespace laver
