#pragma once
#include "reference/bsdf.h"

// Microfacets of Beckmann's distribution in double precision, by angles.
namespace laver::reference {

/// A uniform number in [0, 1] and, independent of it, a unit vector across `axis` of uniform
/// azimuth: height and azimuth over `axis` of a uniform direction on the sphere.
struct Turn {
  double u;
  glm::dvec3 across;
};
Turn turnAround(glm::dvec3 axis, glm::dvec2 numbers);

/// The direction at an angle from `axis`, given by its tangent's square, towards `turn`.
glm::dvec3 tilted(glm::dvec3 axis, const Turn& turn, double squaredTangent);

/// The roughness that is used for a scene's.
double roughness(double alpha);

/// Density of the normals at an angle from the surface's.
double beckmann(double alpha, double cosine);
/// Smith's shadowing to the approximation of Walter and others (2007).
double shadowing(double alpha, double cosine);
/// Draws a normal with density beckmann() * cosine.
glm::dvec3 facetNormal(double alpha, glm::dvec3 normal, glm::dvec2 numbers);

glm::dvec3 mirrored(glm::dvec3 wi, glm::dvec3 normal);
bool bothAbove(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);

/// The reflecting facets between two directions on the upper side.
struct Facets {
  double ci, co, ch;  ///< cosines of wi and wo to the normal, of both to their half vector
  double specular;    ///< D G / (4 ci co)
  double pdf;         ///< of wo, the half vector being drawn by facetNormal()
};
Facets facetsBetween(double alpha, glm::dvec3 normal, glm::dvec3 wi, glm::dvec3 wo);

/// wo with its row's eval * |cosine| / pdf; with 0 where the density is 0.
BsdfSample weighted(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo);

/// Reflectance of a conductor of the index eta + i k.
glm::dvec3 conductorFresnel(double cosine, glm::dvec3 eta, glm::dvec3 k);

}  // namespace laver::reference
