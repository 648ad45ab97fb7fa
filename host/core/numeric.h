#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace laver {

/// The largest |component|.
double maxNorm(const glm::dvec3& v);

/// A unit in the last place of |x| rounded to float: the distance to the next float.
double ulpOf(double x);

/// Distance of a float from the true value, in ulp of the true value.
double ulps(float value, double truth);

/// The smallest value that at least `share` of the values do not exceed (nearest rank); 0 if there
/// are none.
double percentile(std::vector<double> values, double share);

/// The q-quantile by linear interpolation between ranks; q = 0.5 is the median. 0 if there are
/// none.
double quantile(std::vector<double> values, double q);

}  // namespace laver
