#include "lab/explain/bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lab/explain/texture_bounds.h"

namespace laver {
namespace {

using glm::dvec2;
using glm::dvec3;
constexpr double e = 0x1p-24;

double largest(dvec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

}  // namespace

BoundsOf::BoundsOf(const Scene& scene) : scene_(scene), space_(normalisationOf(scene)) {
  const glm::dmat4& m = scene.camera.toWorld;
  eye_ = space_.apply(dvec3(m[3]) / m[3].w);
  reach_ = largest(eye_) + 1.0;
  pixelsAcross_ =
      scene.camera.width / (2.0 * std::tan(scene.camera.fov * std::numbers::pi / 360.0));
}

BoundsOf::Place BoundsOf::placeOf(std::uint32_t id) const {
  for (const Mesh& mesh : scene_.meshes) {
    if (id < mesh.triangles.size()) return {&mesh, mesh.triangles[id]};
    id -= static_cast<std::uint32_t>(mesh.triangles.size());
  }
  return {};
}

double BoundsOf::distanceOf(std::uint32_t id, double u, double v) const {
  const auto [mesh, t] = placeOf(id);
  const dvec3 p =
      (1.0 - u - v) * mesh->positions[t.x] + u * mesh->positions[t.y] + v * mesh->positions[t.z];
  return glm::length(space_.apply(p) - eye_) / space_.scale;
}

// Film position (1 e of the film), three columns (3 e), origin and vertices (2 e O / distance),
// corner - origin, slope, shear, edge functions (11 e O / distance, box.h): 16 e O / distance with
// distance <= 2 O, and twice that because the reference's own hit is as uncertain of the scene.
double BoundsOf::pixelsAt(double distance) const {
  return 32.0 * e * reach_ / (distance * space_.scale) * pixelsAcross_;
}

// Three columns and a film position, the matrix to the picture, and 4 ulp of half a turn: 32 e.
double BoundsOf::pixelsOfBackground() const { return 32.0 * e * pixelsAcross_; }

Bounds BoundsOf::at(std::uint32_t id, double u, double v) const {
  const auto [mesh, t] = placeOf(id);
  const std::array<int, 3> corner{0, 1, 2};
  std::array<dvec3, 3> p;
  for (const int i : corner) p[static_cast<std::size_t>(i)] = space_.apply(mesh->positions[t[i]]);
  const dvec3 hit = (1.0 - u - v) * p[0] + u * p[1] + v * p[2];
  const double distance = glm::length(hit - eye_);
  const dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double longest =
      std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
  const double height = glm::length(cross) / longest;
  const double cosine = std::abs(glm::dot(glm::normalize(cross), (hit - eye_) / distance));

  Bounds b{};
  b.pixels = pixelsAt(distance / space_.scale);
  // Along the ray: origin, vertices, difference and dot products 8 e O, seen under the incidence;
  // the last quotients 4 e.
  b.depth = 4.0 * e + 8.0 * e * reach_ / (distance * cosine);
  // Along the surface.
  const double shift = 8.0 * e * reach_ / cosine;
  b.cause = cosine < 0.1 ? fmt::format("seen at cos {:.2g}", cosine)
                         : fmt::format("triangle of height {:.2g}", height);
  if (mesh->normals.empty()) {
    b.normal = 4.0 * e + 4.0 * e / height;  // rounded corners tilt the plane
  } else {
    const dvec3 a = mesh->normals[t.x], c = mesh->normals[t.y], d = mesh->normals[t.z];
    const double turn = std::max({glm::length(a - c), glm::length(c - d), glm::length(d - a)});
    const double length = std::max(glm::length((1.0 - u - v) * a + u * c + v * d), 1e-30);
    b.normal = (8.0 * e + turn * (shift + 4.0 * e) / height) / length;
    if (length < 0.1) b.cause = "vertex normals that nearly cancel";
  }
  TextureBounds albedo{largest(mesh->bsdf.albedo), 0.0};
  if (mesh->bsdf.texture) {
    std::array<dvec2, 3> uv{dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(0.0, 1.0)};
    for (const int i : corner)
      if (!mesh->uvs.empty()) uv[static_cast<std::size_t>(i)] = mesh->uvs[t[i]];
    const dvec2 low = glm::min(uv[0], glm::min(uv[1], uv[2]));
    const dvec2 high = glm::max(uv[0], glm::max(uv[1], uv[2]));
    // Weights move as those of vertex normals do; coordinates are rounded, and so is their sum.
    const dvec2 moved = (high - low) * (shift + 4.0 * e) / height +
                        4.0 * e * glm::max(glm::abs(low), glm::abs(high));
    albedo =
        textureBounds(*mesh->bsdf.texture, (1.0 - u - v) * uv[0] + u * uv[1] + v * uv[2], moved);
  }
  // Lambert's law: cos / d^2 changes by 3 shifts / d; a light is rounded too.
  for (const PointLight& light : scene_.lights) {
    const dvec3 position = space_.apply(light.position);
    const double d = std::max(glm::length(position - hit), 1e-30);
    const double power = largest(light.radiance) * space_.scale * space_.scale / (d * d);
    const double relative = 8.0 * e + b.normal + 3.0 * (shift + e * (1.0 + largest(position))) / d;
    b.radiance += power / std::numbers::pi * (albedo.largest * relative + albedo.change);
  }
  return b;
}

}  // namespace laver
