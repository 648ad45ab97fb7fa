#include "reference/texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/bsdf.h"
#include "reference/world.h"

namespace laver::reference {

glm::dvec3 pixelAt(const Picture& picture, bool raw, int x, int y) {
  glm::dvec3 color;
  for (int c = 0; c < 3; ++c) {
    const auto channel = static_cast<std::size_t>(c);
    if (const auto* floats = std::get_if<Image>(&picture)) {
      color[c] = static_cast<double>(floats->at(x, y, channel));
      continue;
    }
    const auto& bitmap = std::get<Bitmap>(picture);
    const std::size_t at = static_cast<std::size_t>(y) * static_cast<std::size_t>(bitmap.width) +
                           static_cast<std::size_t>(x);
    const double value = bitmap.pixels[at][channel] / 255.0;
    // IEC 61966-2-1.
    if (raw)
      color[c] = value;
    else
      color[c] = value > 0.04045 ? std::pow((value + 0.055) / 1.055, 2.4) : value / 12.92;
  }
  return color;
}

glm::dvec3 interpolated(const Picture& picture, bool raw, double x, double y, bool repeats) {
  const int width = widthOf(picture), height = heightOf(picture);
  const auto within = [](std::int64_t i, int size) {
    return static_cast<int>((i % size + size) % size);
  };
  const auto left = static_cast<std::int64_t>(std::floor(x - 0.5));
  const auto top = static_cast<std::int64_t>(std::floor(y - 0.5));
  glm::dvec3 sum(0.0);
  for (std::int64_t row = top; row <= top + 1; ++row) {
    for (std::int64_t column = left; column <= left + 1; ++column) {
      const double weight = (1.0 - std::abs(x - 0.5 - static_cast<double>(column))) *
                            (1.0 - std::abs(y - 0.5 - static_cast<double>(row)));
      const int shown = repeats ? within(row, height)
                                : static_cast<int>(std::clamp<std::int64_t>(row, 0, height - 1));
      sum += weight * pixelAt(picture, raw, within(column, width), shown);
    }
  }
  return sum;
}

glm::dvec3 colorOf(const Texture& texture, glm::dvec2 uv) {
  return texture.row->color(texture, texture.scale * uv + texture.offset);
}

// In the frame (x, n x x, n).
glm::dvec3 bsdfNormal(const Surface& surface) {
  const glm::dvec3 n = surface.shading;
  const Texture* map = surface.mesh->bsdf.texture(kNormalMap);
  if (map == nullptr) return n;
  const glm::dvec3 x = frameX(n, surface.tangent);
  const glm::dvec3 shown = 2.0 * colorOf(*map, surface.textureUv) - 1.0;
  const glm::dvec3 bent = glm::dmat3(x, glm::cross(n, x), n) * shown;
  const double length = glm::length(bent);
  return length > 0.0 ? bent / length : n;
}

glm::dvec3 albedoAt(const Bsdf& bsdf, glm::dvec2 uv) {
  const PropertyRow* property = albedoOf(*bsdf.row);
  if (property == nullptr) return glm::dvec3(1.0);
  const Texture* texture = bsdf.texture(property->name);
  return texture != nullptr ? colorOf(*texture, uv) : bsdf.color(property->name);
}

}  // namespace laver::reference
