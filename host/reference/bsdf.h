#pragma once
#include <glm/glm.hpp>

#include "scene/bsdfs.h"

namespace laver::reference {

/// The input of a BSDF: a point of a surface.
struct BsdfPoint {
  const Bsdf& bsdf;
  glm::dvec3 colour;  ///< albedo, from the texture if there is one
  glm::dvec3 normal;  ///< unit shading normal
};

/// A sampled direction and BSDF * |cosine| / density; 0 if the path ends.
struct BsdfSample {
  glm::dvec3 wo;
  glm::dvec3 weight;
};

/// Fresnel reflectance of unpolarised light at a dielectric (Born and Wolf, "Principles of Optics",
/// 1.5). `cosine` is relative to the normal, positive on the side with index `outside`.
double fresnel(double cosine, double outside, double inside);

}  // namespace laver::reference
