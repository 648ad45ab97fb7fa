#include "reference/bsdf.h"

namespace laver::reference {

/// No surface: light goes straight on. A delta distribution.
glm::dvec3 nullEval(const BsdfPoint&, glm::dvec3, glm::dvec3) { return glm::dvec3(0.0); }

double nullPdf(const BsdfPoint&, glm::dvec3, glm::dvec3) { return 0.0; }

BsdfSample nullSample(const BsdfPoint&, glm::dvec3 wi, glm::dvec2) {
  return {-wi, glm::dvec3(1.0)};
}

}  // namespace laver::reference
