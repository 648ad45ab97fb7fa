#include "random/viewpoint.h"

#include <fmt/format.h>

#include "random/lighting.h"
#include "scene/transform.h"

namespace laver::test {
namespace {

using glm::dvec3;

double degreesAcross(double size, double distance) {
  return glm::degrees(2.0 * std::atan(0.5 * size / distance));
}

struct View {
  dvec3 eye;
  double fov;
};

View viewOf(dvec3 target, const Scene& scene, Draw& draw, std::string& traits) {
  const dvec3 from = draw.direction();
  switch (draw.below(8)) {
    case 0: {
      const double distance = draw.scale(10.0, 1e5);
      traits += fmt::format("; seen from {:.2g}", distance);
      return {target + distance * from, degreesAcross(2.0, distance)};
    }
    case 1: {
      const double size = draw.scale(1e-4, 1.0);
      traits += fmt::format("; {:.2g} seen", size);
      return {target + 3.0 * from, degreesAcross(size, 3.0)};
    }
    case 2:
      traits += "; wide view";
      return {target + draw.between(0.3, 2.0) * from, draw.between(100.0, 170.0)};
    case 3: {
      const double distance = draw.scale(1e-3, 1.0);
      traits += fmt::format("; seen from {:.2g}", distance);
      return {target + distance * from, draw.between(30.0, 90.0)};
    }
    case 4:
      for (const Mesh& mesh : scene.meshes)
        if (mesh.sphere) {
          traits += "; from inside a sphere";
          return {mesh.sphere->centre + 0.5 * draw.unit() * mesh.sphere->radius * from, 60.0};
        }
      [[fallthrough]];
    default:
      return {target + draw.between(2.0, 5.0) * from, draw.between(20.0, 60.0)};
  }
}

/// Of the camera's own space, which the transform may distort.
glm::dmat4 distorted(glm::dmat4 toWorld, Draw& draw, std::string& traits) {
  if (draw.chance(0.1)) {
    traits += "; camera mirrored";
    toWorld[0] = -toWorld[0];
  }
  if (draw.chance(0.1)) {
    traits += "; camera sheared";
    glm::dmat4 shear(1.0);
    shear[1][0] = draw.between(-1.0, 1.0);
    shear[0][0] = draw.between(0.5, 2.0);
    toWorld *= shear;
  }
  return toWorld;
}

}  // namespace

void chooseView(const Kind& kind, Scene& scene, Draw& draw, std::string& traits) {
  const dvec3 target =
      draw.chance(0.7) ? 0.2 * draw.point() : pointOn(scene.meshes[draw.below(3)], draw);
  const View view = viewOf(target, scene, draw, traits);
  Camera& camera = scene.camera;
  camera.toWorld =
      distorted(lookAt(view.eye, target, draw.direction()).value_or(glm::dmat4(1.0)), draw, traits);
  camera.fov = view.fov;
  camera.width = draw.integer(16, 24);
  camera.height = draw.integer(16, 24);
  const double distance = glm::length(target - view.eye);
  camera.nearClip = 1e-4 * std::min(distance, 1.0);
  camera.farClip = 1e14;
  if (draw.chance(0.1)) {
    traits += "; clipped";
    camera.nearClip = std::max(0.1, distance - draw.between(0.0, 1.0));
    camera.farClip = camera.nearClip + draw.between(0.1, 2.0);
  }
  if (!kind.lens) return;
  traits += "; lens";
  camera.row = &cameras::thinlens;
  camera.lensRadius = distance * draw.scale(1e-3, 0.2);
  camera.focalDistance = distance * draw.between(0.5, 2.0);
}

}  // namespace laver::test
