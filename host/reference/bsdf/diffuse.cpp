#include <numbers>

#include "reference/bsdf.h"
#include "reference/openness.h"

namespace laver::reference {

/// Lambertian reflection: albedo / pi on the upper side.
glm::dvec3 diffuseEval(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  const bool above = glm::dot(point.normal, wi) > 0.0 && glm::dot(point.normal, wo) > 0.0;
  return above ? point.color("albedo") / std::numbers::pi : glm::dvec3(0.0);
}

double diffusePdf(const BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) {
  const double cosine = glm::dot(point.normal, wo);
  return glm::dot(point.normal, wi) > 0.0 && cosine > 0.0 ? cosine / std::numbers::pi : 0.0;
}

BsdfSample diffuseSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2 numbers) {
  const bool above = glm::dot(point.normal, wi) > 0.0;
  return {cosineAround(point.normal, numbers), above ? point.color("albedo") : glm::dvec3(0.0)};
}

}  // namespace laver::reference
