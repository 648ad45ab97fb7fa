#include "render/camera_data.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace laver {
namespace {

using glm::dvec3;
using glm::vec3;
using glm::vec4;

}  // namespace

void packCamera(const Scene& scene, SceneData& data) {
  const Camera& camera = scene.camera;
  const glm::dmat4& m = camera.toWorld;
  const dvec3 origin = dvec3(m[3]) / m[3].w;

  // A camera may be scaled; kappa brings its directions to about unit length.
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(m[column][row]));
  const double kappa = std::ldexp(1.0, -std::ilogb(largest));

  // In camera space the ray through film position (px, py) is (q, 1) with q = (1 - 2 px / w) T,
  // (1 - 2 py / h) T h / w, T = tan(fov / 2); both are T / w times (w - 2 px), (h - 2 py). Then t
  // is the distance along the camera's axis, in which the clip planes are given.
  const double pixel = std::tan(camera.fov * std::numbers::pi / 360.0) / camera.width;
  data.params.origin = vec4(vec3(data.space.apply(origin)), 0.0F);
  data.params.columnX = vec4(vec3(dvec3(m[0]) * (kappa * pixel)), 0.0F);
  data.params.columnY = vec4(vec3(dvec3(m[1]) * (kappa * pixel)), 0.0F);
  data.params.columnZ = vec4(vec3(dvec3(m[2]) * kappa), 0.0F);
  const double scale = data.space.scale / kappa;
  // Far planes beyond 1e37 are as good as none, and times a direction stay finite.
  const auto clip = [&](double z) { return static_cast<float>(std::clamp(z * scale, 0.0, 1e37)); };
  data.params.clip = vec4(clip(camera.nearClip), clip(camera.farClip),
                          static_cast<float>(1.0 / data.space.scale), 0.0F);
  data.params.film.x = static_cast<std::uint32_t>(camera.width);
  data.params.film.y = static_cast<std::uint32_t>(camera.height);
}

void packFilter(const Filter& f, SceneData& data) {
  const double alpha = -1.0 / (2.0 * f.stddev * f.stddev);
  vec4& args = data.params.filterArgs;
  args = vec4(static_cast<float>(f.radius), 0.0F, 0.0F, static_cast<float>(filterConstant(f)));
  if (f.row == &filters::gaussian) {
    args.y = static_cast<float>(alpha);
    args.z = static_cast<float>(std::exp(alpha * f.radius * f.radius));
  } else if (f.row == &filters::mitchell) {
    args.y = static_cast<float>(f.B);
    args.z = static_cast<float>(f.C);
  }
  // Nori's table: 32 entries over the radius, and a last one of 0.
  const bool nori = data.constants[shared::SPEC_NORI_TABLE] != 0;
  for (int i = 0; i < 32; ++i)
    data.params.table[i / 4][i % 4] = static_cast<float>(
        nori ? f.row->evaluate(f, f.radius * i / 32.0) : std::exp(alpha * i * i));
  data.params.table[8] = vec4(0.0F);
}

}  // namespace laver
