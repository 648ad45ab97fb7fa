#pragma once
#include <glm/glm.hpp>

#include "scene/emitters.h"

namespace laver::reference {

/// A sample of a light for a point of a surface.
struct LightSample {
  glm::dvec3 position;
  glm::dvec3 radiance;  ///< divided by the squared distance; 0 at distance 0
};

/// A drawn direction, of unit length, and its density per solid angle.
struct DirectionSample {
  glm::dvec3 direction;
  double density;
};

/// The cell of an image's grid in which a direction lies, and the density per solid angle of
/// directions that are drawn from it; otherwise cell 0.
struct CellDensity {
  std::size_t cell;
  double density;
};

}  // namespace laver::reference
