#include "reference/integrators.h"

namespace laver::reference {

glm::dvec3 radiance(const World& world, const Scene& scene, const IntegratorUse& integrator,
                    const CameraRay& camera, const Numbers& numbers) {
  return integrator.row->radiance({world, scene, integrator, camera.ray.direction,
                                   world.closest(camera.ray, camera.tmin, camera.tmax), numbers});
}

}  // namespace laver::reference
