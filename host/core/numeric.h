#pragma once
#include <glm/glm.hpp>
#include <vector>

namespace laver {

/// The largest |component|.
double maxNorm(const glm::dvec3& v);

/// Distance from |x|, rounded to float, to the next float: a unit in the last place.
double ulpOf(double x);

/// Distance of a float from the truth in units of the last place of the truth.
double ulps(float value, double truth);

/// The smallest of the values that a share of them does not exceed (nearest rank); 0 of none.
double percentile(std::vector<double> values, double share);

/// Linear interpolation between ranks; q = 0.5 is the median. 0 of none.
double quantile(std::vector<double> values, double q);

}  // namespace laver
