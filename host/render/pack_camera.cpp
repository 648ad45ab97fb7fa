#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/pack_parts.h"

namespace laver {

using glm::dvec3;
using glm::vec3;

void packCamera(const Camera& camera, Packed& packed) {
  const glm::dmat4& m = camera.toWorld;
  const dvec3 origin = dvec3(m[3]) / m[3].w;

  // The camera's transform may scale; kappa brings its directions to about unit length.
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  const double kappa = std::ldexp(1.0, -std::ilogb(largest));

  // In camera space the ray through film position (px, py) is (q, 1) with q = (1 - 2 px / w) T, (1
  // - 2 py / h) T h / w, T = tan(fov / 2); both are T / w times (w - 2 px), (h - 2 py). Then t is
  // the distance along the camera's axis, in which the clip planes are given.
  const double pixel = std::tan(camera.fov * std::numbers::pi / 360.0) / camera.width;
  shared::Params& p = packed.params;
  // Where rays start, at z = start of camera space.
  const double start = packed.space.start;
  packed.eye = packed.space.apply(origin);
  p.origin = vec3(packed.space.apply(origin + dvec3(m[2]) * start));
  p.startX = vec3(dvec3(m[0]) * (start * pixel * packed.space.scale));
  p.startY = vec3(dvec3(m[1]) * (start * pixel * packed.space.scale));
  p.columnX = vec3(dvec3(m[0]) * (kappa * pixel));
  p.columnY = vec3(dvec3(m[1]) * (kappa * pixel));
  p.columnZ = vec3(dvec3(m[2]) * kappa);
  const double scale = packed.space.scale / kappa;
  const auto clip = [&](double z) {
    return static_cast<float>(std::clamp(z * scale, 0.0, static_cast<double>(shared::FAR_AWAY)));
  };
  p.startT = clip(start);
  p.tmin = clip(camera.nearClip - start);
  p.tmax = clip(camera.farClip - start);
  const double lens = camera.lensRadius * packed.space.scale / m[3].w;
  p.lensX = vec3(dvec3(m[0]) * lens);
  p.lensY = vec3(dvec3(m[1]) * lens);
  p.lensToDirection = static_cast<float>(m[3].w / (scale * camera.focalDistance));
  p.lensAtStart = static_cast<float>(1.0 - start * m[3].w / camera.focalDistance);
  p.sceneReach = static_cast<float>(packed.space.reach);
  p.sceneUnits = static_cast<float>(1.0 / packed.space.scale);
  p.filmSize = {static_cast<std::uint32_t>(camera.width),
                static_cast<std::uint32_t>(camera.height)};
}

void packFilter(const Filter& filter, bool noriTable, shared::Params& params) {
  params.filterRadius = static_cast<float>(filter.radius);
  if (filter.row->shape != nullptr) params.filterShape = glm::vec2(filter.row->shape(filter));
  // Nori's table: 32 entries over the radius, followed by a 0.
  const double alpha = -1.0 / (2.0 * filter.stddev * filter.stddev);
  for (int i = 0; i < 32; ++i)
    params.filterTable[i / 4][i % 4] =
        static_cast<float>(noriTable ? filter.row->evaluate(filter, filter.radius * i / 32.0)
                                     : std::exp(alpha * i * i));
  params.filterTable[8] = glm::vec4(0.0F);
}

}  // namespace laver
