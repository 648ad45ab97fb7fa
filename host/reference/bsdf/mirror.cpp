#include "reference/bsdf.h"

namespace laver::reference {

/// A perfect mirror on the upper side: a delta distribution.
glm::dvec3 mirrorEval(const BsdfPoint&, glm::dvec3, glm::dvec3) { return glm::dvec3(0.0); }

double mirrorPdf(const BsdfPoint&, glm::dvec3, glm::dvec3) { return 0.0; }

BsdfSample mirrorSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2) {
  const double cosine = glm::dot(point.normal, wi);
  return {2.0 * cosine * point.normal - wi, glm::dvec3(cosine > 0.0 ? 1.0 : 0.0)};
}

}  // namespace laver::reference
