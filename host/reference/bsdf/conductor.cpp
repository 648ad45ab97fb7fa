#include "reference/facets.h"

namespace laver::reference {

/// A smooth conductor on the upper side: a delta distribution.
glm::dvec3 conductorEval(const BsdfPoint&, glm::dvec3, glm::dvec3) { return glm::dvec3(0.0); }

double conductorPdf(const BsdfPoint&, glm::dvec3, glm::dvec3) { return 0.0; }

BsdfSample conductorSample(const BsdfPoint& point, glm::dvec3 wi, glm::dvec2) {
  const double cosine = glm::dot(point.normal, wi);
  return {mirrored(wi, point.normal),
          cosine > 0.0 ? point.color("specularReflectance") *
                             conductorFresnel(cosine, point.color("eta"), point.color("k"))
                       : glm::dvec3(0.0)};
}

}  // namespace laver::reference
