#include "reference/bsdf.h"

#include <cmath>
#include <utility>

namespace laver::reference {

double fresnel(double cosine, double outside, double inside) {
  if (outside == inside) return 0.0;
  if (cosine < 0.0) std::swap(outside, inside);
  const double eta = outside / inside, c1 = std::abs(cosine);
  const double sine2 = eta * eta * (1.0 - c1 * c1);
  if (sine2 > 1.0) return 1.0;
  const double c2 = std::sqrt(1.0 - sine2);
  const double parallel = (outside * c2 - inside * c1) / (outside * c2 + inside * c1);
  const double perpendicular = (outside * c1 - inside * c2) / (outside * c1 + inside * c2);
  return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

}  // namespace laver::reference
