#include "reference/integrators.h"

namespace laver::reference {

glm::dvec3 radiance(const Lit& lit, const IntegratorUse& integrator, const CameraRay& camera,
                    const Numbers& numbers) {
  return integrator.row->radiance(
      {lit.world, lit.sources, lit.scene, integrator, camera.ray.origin, camera.ray.direction,
       lit.world.closest(camera.ray, camera.tmin, camera.tmax), numbers});
}

}  // namespace laver::reference
