#include "lab/explain/bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "core/numeric.h"
#include "render/materials.h"
#include "render/split_meshes.h"

namespace laver {
namespace {

using glm::dvec2;
using glm::dvec3;
constexpr double e = kUnitRoundoff;
constexpr double pi = std::numbers::pi;

/// Bounds of a material's albedo around a point.
struct AlbedoBounds {
  double largest;  ///< of any channel
  double change;   ///< largest change of a channel when the point moves within its bound
};

double valueOf(const Picture& picture, bool raw, std::size_t index, std::size_t channel) {
  if (const auto* image = std::get_if<Image>(&picture))
    return static_cast<double>(image->pixels[3 * index + channel]);
  const double x = std::get<Bitmap>(picture).pixels[index][channel] / 255.0;
  return raw ? x : linearOfSrgb(x);
}

/// Bounds of a texture at `uv`, which may move by `shift` on each axis. The edges of a checker are
/// ignored: which of its colours a sample gets is a decision, not a rounding error.
AlbedoBounds albedoBounds(const Texture& texture, dvec2 uv, dvec2 shift) {
  const double factor = maxNorm(texture.colors[0]);
  if (!texture.row->picture) return {std::max(factor, maxNorm(texture.colors[1])), 0.0};
  if (!texture.image) return {factor, 0.0};
  const Picture& picture = *texture.image;
  const glm::ivec2 size(widthOf(picture), heightOf(picture));
  const dvec2 st = texture.scale * uv + texture.offset;
  // Roundings: product and sum, the fractional part, the product with the size, and the half pixel.
  const dvec2 moved =
      (glm::abs(texture.scale) * shift + 4.0 * e * (glm::abs(st) + 1.0)) * dvec2(size);
  const dvec2 place((st.x - std::floor(st.x)) * size.x - 0.5,
                    (1.0 - (st.y - std::floor(st.y))) * size.y - 0.5);
  // Pixels between which the point may lie.
  const glm::ivec2 reach(glm::min(moved, dvec2(64.0)) + 1.0);
  const glm::ivec2 low = glm::ivec2(glm::floor(place)) - reach;
  const glm::ivec2 high = glm::ivec2(glm::floor(place)) + 1 + reach;
  const auto around = [](int i, int n) { return (i % n + n) % n; };
  AlbedoBounds bounds{0.0, 0.0};
  double range = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    double min = std::numeric_limits<double>::infinity(), max = -min;
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const int index = around(y, size.y) * size.x + around(x, size.x);
        const double value = valueOf(picture, texture.raw, static_cast<std::size_t>(index), c);
        min = std::min(min, value);
        max = std::max(max, value);
      }
    bounds.largest = std::max({bounds.largest, std::abs(min), std::abs(max)});
    range = std::max(range, max - min);
  }
  // The slope along each axis is at most one range per pixel.
  bounds.change = factor * (range * std::min(1.0, moved.x + moved.y) + 8.0 * e * bounds.largest);
  bounds.largest *= factor;
  return bounds;
}

}  // namespace

/// The surface around a hit; lengths in normalised space.
struct BoundsOf::Local {
  double depth;   // relative
  double shift;   // of the hit along the surface
  double normal;  // angle
  dvec2 uv{0.0}, uvShift{0.0};
  std::string cause;
};

BoundsOf::BoundsOf(const Scene& scene, const Rounding& rounding)
    : scene_(scene), rounding_(rounding), space_(rounding.space()) {
  const glm::dmat4& m = scene.camera.toWorld;
  eye_ = space_.apply(dvec3(m[3]) / m[3].w);
}

/// `corner`: the farthest one's distance from the centre of device coordinates.
double BoundsOf::sideways(dvec2 film, double distance, double farthest, double corner) const {
  const double scale = space_.scale;
  return rounding_.sideways(film, distance / scale, farthest / scale, corner / scale) * scale;
}

BoundsOf::Local BoundsOf::onTriangle(dvec2 film, const Reference::Hit& hit, const Mesh& mesh,
                                     const glm::uvec3& t) const {
  const std::array<double, 3> weights{1.0 - hit.u - hit.v, hit.u, hit.v};
  std::array<dvec3, 3> p = pieceAt({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]},
                                   dvec3(weights[0], weights[1], weights[2]), space_);
  for (dvec3& corner : p) corner = space_.apply(corner);
  const dvec3 direction = space_.apply(hit.position) - eye_;
  const double distance = glm::length(direction);
  const dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double longest =
      std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
  const double height = glm::length(cross) / longest;
  const double cosine = std::abs(glm::dot(glm::normalize(cross), direction / distance));

  Local local{};
  local.cause = cosine < 0.1 ? fmt::format("seen at cos {:.2g}", cosine)
                             : fmt::format("triangle of height {:.2g}", height);
  const double corner = std::max({glm::length(p[0]), glm::length(p[1]), glm::length(p[2])});
  const double aside =
      sideways(film, distance, corner + rounding_.originReach() * space_.scale, corner);
  local.shift = aside / cosine;
  // Distance along the plane. Roundings: the normal, 4 e by accurateCross(), corners and edges; dot
  // products, 3 e each; quotient and product, 4 e. `aside` includes the rounding of the ray's
  // direction and of the corners.
  local.depth = 4.0 * e + (aside + 14.0 * e * distance + 2.0 * e * longest) / (distance * cosine);
  // The plane is tilted by the rounding of corners, e |v| each, and of edges.
  local.normal = 8.0 * e + (2.0 * corner + longest) * e / height;
  const double moved = local.shift / height + 10.0 * e;  // change of the weights
  if (!mesh.normals.empty()) {
    std::array<dvec3, 3> n;
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < 3; ++i) {
      n[i] = mesh.normals[t[static_cast<int>(i)]];
      sum += weights[i] * n[i];
    }
    const double spread =
        std::max({glm::length(n[0] - n[1]), glm::length(n[1] - n[2]), glm::length(n[2] - n[0])});
    const double length = std::max(glm::length(sum), 1e-30);
    local.normal = (8.0 * e + spread * moved) / length;
    if (length < 0.1) local.cause = "vertex normals that nearly cancel";
  }
  std::array<dvec2, 3> uv{dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(0.0, 1.0)};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!mesh.uvs.empty()) uv[i] = mesh.uvs[t[static_cast<int>(i)]];
    local.uv += weights[i] * uv[i];
  }
  const dvec2 low = glm::min(uv[0], glm::min(uv[1], uv[2]));
  const dvec2 high = glm::max(uv[0], glm::max(uv[1], uv[2]));
  // Both the coordinates and their weighted sum are rounded.
  local.uvShift = (high - low) * moved + 4.0 * e * glm::max(glm::abs(low), glm::abs(high));
  return local;
}

BoundsOf::Local BoundsOf::onSphere(dvec2 film, const Reference::Hit& hit,
                                   const Sphere& sphere) const {
  const double radius = sphere.radius * space_.scale;
  const dvec3 normal = glm::normalize(hit.position - sphere.centre);
  const dvec3 direction = space_.apply(hit.position) - eye_;
  const double distance = glm::length(direction);
  const double cosine = std::abs(glm::dot(normal, direction / distance));

  Local local{};
  local.cause = cosine < 0.1 ? fmt::format("sphere seen at cos {:.2g}", cosine)
                             : fmt::format("sphere of radius {:.2g}", radius);
  // A line that moves sideways by s rotates the normal by s / (r cos), and near the outline by at
  // most sqrt(2 s / r). The normal's length errs by 8 e (sphere.h).
  const double origin = rounding_.originReach() * space_.scale;
  const double nearest = std::abs(glm::length(space_.apply(sphere.centre)) - radius);
  const double corner = isCap(sphere, space_) ? nearest + glm::length(space_.apply(hit.position))
                                              : glm::length(space_.apply(sphere.centre)) + radius;
  const double aside = sideways(film, distance, corner + origin, corner);
  const double rotation = std::min(aside / (radius * cosine), std::sqrt(2.0 * aside / radius));
  local.normal = 8.0 * e + rotation;
  local.shift = rotation * radius;
  local.depth = 4.0 * e + (aside + local.shift) / distance;
  // Longitude and latitude as fractions of a turn, each within 4 e (texture/angle.glsl).
  const double parallel = std::hypot(normal.x, normal.y);
  local.uv = {0.5 + std::atan2(normal.y, normal.x) / (2.0 * pi),
              0.5 + std::asin(std::clamp(normal.z, -1.0, 1.0)) / pi};
  local.uvShift =
      8.0 * e + local.normal * dvec2(1.0 / (2.0 * pi * std::max(parallel, 1e-30)), 1.0 / pi);
  return local;
}

/// Change of a spot light's share where its intensity falls; at most 1. The slope of a fourth power
/// is at most 4.
double edgeOf(const PointLight& light, const dvec3& position, const dvec3& point, double shift) {
  if (light.row != &emitters::spot) return 0.0;
  const dvec3 away = point - position;
  const double d = std::max(glm::length(away), 1e-30);
  const double along = glm::dot(light.axis, away) / d;
  const double outer = std::cos(glm::radians(light.outer));
  const double inner = std::cos(glm::radians(light.inner));
  // The angle changes by no more than shift / d; it is the cosine's change over its sine.
  const double sine = std::sqrt(std::max(1.0 - along * along, e));
  const double change =
      (8.0 * e + 2.0 * (shift + e * (maxNorm(point) + maxNorm(position))) / d) / sine;
  if (along < outer - change || along > inner + change) return 8.0 * change;
  return std::min(1.0, 4.0 * change / std::max(inner - outer, change));
}

ValueBounds BoundsOf::at(dvec2 film, const Reference::Hit& hit) const {
  auto mesh = scene_.meshes.begin();
  std::size_t number = hit.triangle;
  for (; number >= mesh->primitives(); ++mesh) number -= mesh->primitives();
  const Local local = mesh->sphere ? onSphere(film, hit, *mesh->sphere)
                                   : onTriangle(film, hit, *mesh, mesh->triangles[number]);
  const PropertyRow* shown = albedoOf(*mesh->bsdf.row);
  const Texture* texture = shown != nullptr ? mesh->bsdf.texture(shown->name) : nullptr;
  const AlbedoBounds albedo = texture != nullptr
                                  ? albedoBounds(*texture, local.uv, local.uvShift)
                                  : AlbedoBounds{maxNorm(laver::albedoOf(*mesh)), 0.0};
  ValueBounds bounds{local.depth, local.normal, 0.0, local.cause};
  // cos / d^2 changes by 3 shifts / d; the light's position is rounded, too.
  const dvec3 point = space_.apply(hit.position);
  for (const PointLight& light : scene_.lights) {
    const dvec3 position = space_.apply(light.position);
    const bool directional = light.row == &emitters::directional;
    const double d = directional ? 1.0 : std::max(glm::length(position - point), 1e-30);
    const double power =
        maxNorm(light.radiance) * (directional ? 1.0 : space_.scale * space_.scale / (d * d));
    const double relative =
        8.0 * e + local.normal + 3.0 * (local.shift + e * (maxNorm(point) + maxNorm(position))) / d;
    bounds.radiance +=
        power / pi *
        (albedo.largest * (relative + edgeOf(light, position, point, local.shift)) + albedo.change);
  }
  return bounds;
}

}  // namespace laver
