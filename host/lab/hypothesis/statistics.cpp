#include "lab/hypothesis/statistics.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>
#include <vector>

namespace laver {

Tested studentTest(const Moments& sample, double reference) {
  const auto n = static_cast<double>(sample.count());
  Tested result;
  result.freedom = static_cast<std::int64_t>(sample.count()) - 1;
  result.statistic =
      std::abs(sample.mean() - reference) * std::sqrt(n / std::max(sample.variance(), 1e-5));
  if (result.freedom < 1 || !std::isfinite(result.statistic)) return result;
  const boost::math::students_t distribution(static_cast<double>(result.freedom));
  result.p = 2.0 * boost::math::cdf(boost::math::complement(distribution, result.statistic));
  return result;
}

Tested chiSquaredTest(std::span<const double> observed, std::span<const double> expected,
                      double least) {
  const double total = std::accumulate(observed.begin(), observed.end(), 0.0);
  Tested result;
  double pooledObserved = 0.0, pooledExpected = 0.0;
  std::int64_t cells = 0;
  const auto add = [&](double seen, double wanted) {
    result.statistic += (seen - wanted) * (seen - wanted) / wanted;
    ++cells;
  };
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!(expected[i] >= 0.0)) return {};
    if (expected[i] == 0.0) {
      if (observed[i] > total * 1e-5) return {};
    } else if (expected[i] < least) {
      pooledObserved += observed[i];
      pooledExpected += expected[i];
    } else {
      add(observed[i], expected[i]);
    }
  }
  if (pooledExpected > 0.0) add(pooledObserved, pooledExpected);
  result.freedom = cells - 1;
  if (result.freedom < 1 || !std::isfinite(result.statistic)) return result;
  const boost::math::chi_squared distribution(static_cast<double>(result.freedom));
  result.p = boost::math::cdf(boost::math::complement(distribution, result.statistic));
  return result;
}

double sidakLevel(double level, std::size_t tests) {
  return -std::expm1(std::log1p(-level) / static_cast<double>(tests));
}

}  // namespace laver
