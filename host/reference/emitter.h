#pragma once
#include <glm/glm.hpp>

#include "scene/emitters.h"

namespace laver::reference {

/// A point of a light as a surface sees it.
struct LightSample {
  glm::dvec3 position;
  glm::dvec3 radiance;  ///< over the square of the distance; 0 at distance 0
};

/// A drawn direction, of unit length, and its density per solid angle.
struct DirectionSample {
  glm::dvec3 direction;
  double density;
};

}  // namespace laver::reference
