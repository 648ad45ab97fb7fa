#include "render/pack_textures.h"

#include <algorithm>
#include <cmath>

#include "render/materials.h"

namespace laver {
using glm::vec2;
using glm::vec3;

namespace {

/// What texture coordinates may leave out: as many whole periods as fit into `uv`, if all textures
/// of the mesh repeat and have one scale. Otherwise 0.
glm::dvec2 wholePeriods(const Mesh& mesh, glm::dvec2 uv) {
  const Texture* first = nullptr;
  for (const Texture* texture : texturesOf(mesh)) {
    if (first == nullptr) first = texture;
    if (!texture->row->repeats || texture->scale != first->scale) return glm::dvec2(0.0);
  }
  glm::dvec2 whole(0.0);
  for (int axis = 0; first != nullptr && axis < 2; ++axis) {
    const double scale = first->scale[axis];
    if (scale != 0.0) whole[axis] = 2.0 * std::floor(0.5 * uv[axis] * scale) / scale;
  }
  return whole;
}

}  // namespace

void TexturePacker::beginMesh(const Mesh& mesh, std::uint32_t firstId) {
  textured_ = hasTextures(mesh) || usesTangent(mesh.bsdf);
  uvs_ = static_cast<std::uint32_t>(packed_.uvs.size() / 3) - firstId;
}

std::uint32_t TexturePacker::addRecord(const Texture& texture) {
  const auto kind = std::find(kinds_.begin(), kinds_.end(), texture.row->name);
  shared::Texture record{};
  record.kind = static_cast<std::uint32_t>(kind - kinds_.begin());
  record.color1 = vec3(texture.colors[0]);
  record.color2 = vec3(texture.colors[1]);
  record.scale = vec2(texture.scale);
  record.offset = vec2(texture.offset);
  if (texture.image) record.image = add(*texture.image, texture.raw, texture.red);
  record.uvs = uvs_;
  packed_.textures.push_back(record);
  return static_cast<std::uint32_t>(packed_.textures.size() - 1);
}

void TexturePacker::addTriangle(const Mesh& mesh, glm::uvec3 given, glm::uvec3 stored) {
  if (!textured_) return;
  for (int corner = 0; corner < 3; ++corner) {
    const std::uint32_t vertex = stored[corner];
    // Without coordinates, u and v are the barycentric weights of the second and the third corner.
    packed_.uvs.push_back(!mesh.uvs.empty() ? vec2(mesh.uvs[vertex])
                                            : vec2(vertex == given.y, vertex == given.z));
  }
}

void TexturePacker::addPiece(const Mesh& mesh, const Piece& piece, glm::uvec3 stored) {
  if (!textured_) return;
  glm::dmat3x2 uv;
  for (int corner = 0; corner < 3; ++corner) {
    int place = 0;
    while (piece.corners[place] != stored[corner]) ++place;
    const glm::dvec3& w = piece.weights[static_cast<std::size_t>(place)];
    uv[corner] = mesh.uvs.empty() ? glm::dvec2(w.y, w.z) : mesh.uvs[stored[corner]];
  }
  const glm::dvec2 whole = wholePeriods(mesh, uv[0]);
  for (int corner = 0; corner < 3; ++corner) packed_.uvs.push_back(vec2(uv[corner] - whole));
}

void TexturePacker::packBackground(const Environment& environment) {
  // Only directions matter; entries of about 1 keep them far from the limits of float.
  glm::dmat3 inverse = glm::inverse(glm::dmat3(environment.toWorld));
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(inverse[column][row]));
  inverse /= largest;
  const auto row = [&](int i) { return vec3(inverse[0][i], inverse[1][i], inverse[2][i]); };
  shared::Params& p = packed_.params;
  p.backgroundX = row(0);
  p.backgroundY = row(1);
  p.backgroundZ = row(2);
  p.backgroundRadiance = vec3(environment.radiance);
  p.backgroundAxis = vec3(glm::normalize(glm::dvec3(environment.toWorld[2])));
  p.backgroundVersine =
      static_cast<float>(2.0 * std::pow(std::sin(0.5 * glm::radians(environment.angle)), 2));
  if (environment.image) p.backgroundImage = add(*environment.image, environment.raw, false);
}

std::uint32_t TexturePacker::tableOf(bool raw) {
  const auto [entry, added] =
      tables_.emplace(raw, static_cast<std::uint32_t>(packed_.images.size()));
  for (int i = 0; added && i < 256; ++i) {
    const double x = i / 255.0;
    packed_.images.push_back(
        shared::floatBitsToUint(static_cast<float>(raw ? x : linearOfSrgb(x))));
  }
  return entry->second;
}

shared::ImageRef TexturePacker::add(const Picture& picture, bool raw, bool red) {
  const auto* bitmap = std::get_if<Bitmap>(&picture);
  const std::uint32_t table = bitmap != nullptr ? tableOf(raw) : shared::NO_TABLE;
  std::vector<std::uint32_t>& words = packed_.images;
  const auto [entry, added] =
      pictures_.emplace(std::pair(&picture, red), static_cast<std::uint32_t>(words.size()));
  if (added && bitmap != nullptr) {
    for (const Rgb8& p : bitmap->pixels)
      words.push_back(
          static_cast<std::uint32_t>(p[0] | p[red ? 0 : 1] << 8 | p[red ? 0 : 2] << 16));
  } else if (added) {
    const auto& pixels = std::get<Image>(picture).pixels;
    for (std::size_t i = 0; i < pixels.size(); ++i)
      words.push_back(shared::floatBitsToUint(pixels[red ? i - i % 3 : i]));
  }
  return {entry->second, static_cast<std::uint32_t>(widthOf(picture)),
          static_cast<std::uint32_t>(heightOf(picture)), table};
}

}  // namespace laver
