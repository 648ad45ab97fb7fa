#pragma once
#include <glm/glm.hpp>

#include "scene/bsdfs.h"

namespace laver::reference {

/// A point of a surface as BSDFs see it.
struct BsdfPoint {
  const Bsdf& bsdf;
  glm::dvec3 colour;  ///< of the material there, its texture's if it has one
  glm::dvec3 normal;  ///< unit shading normal
};

/// A drawn direction and BSDF * |cosine| / density: 0 where nothing goes on.
struct BsdfSample {
  glm::dvec3 wo;
  glm::dvec3 weight;
};

/// Fresnel reflectance of unpolarised light at a dielectric (Born and Wolf, "Principles of
/// Optics", 1.5), by the cosine to the normal: above 0 from the side with index `outside`.
double fresnel(double cosine, double outside, double inside);

}  // namespace laver::reference
