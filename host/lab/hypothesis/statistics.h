#pragma once
#include <cstdint>
#include <span>

// Hypothesis tests. A hypothesis is rejected where its p-value, the probability of a result that is
// at least as far off if it is true, is below the significance level.
namespace laver {

/// Mean and unbiased variance of numbers, in one pass (Welford, "Note on a Method for Calculating
/// Corrected Sums of Squares and Products", 1962).
class Moments {
 public:
  void add(double x) {
    const double before = x - mean_;
    mean_ += before / static_cast<double>(++count_);
    squares_ += before * (x - mean_);
  }
  std::uint64_t count() const { return count_; }
  double mean() const { return mean_; }
  double variance() const { return count_ < 2 ? 0.0 : squares_ / static_cast<double>(count_ - 1); }

 private:
  std::uint64_t count_ = 0;
  double mean_ = 0.0, squares_ = 0.0;
};

struct Tested {
  double statistic = 0.0;
  std::int64_t freedom = 0;  ///< degrees of it
  double p = 0.0;
};

/// Student's t-test of a mean, two-sided. A variance below 1e-5 counts as that much, so that a
/// reference value of five digits is met by numbers without noise.
Tested studentTest(const Moments& sample, double reference);

/// Pearson's chi-squared test of counts. Cells that expect fewer than `least` are pooled. p is 0
/// where a cell without an expectation holds more than 1e-5 of all, where an expectation is
/// negative, and where there are not two cells to compare.
Tested chiSquaredTest(std::span<const double> observed, std::span<const double> expected,
                      double least);

/// The level of each of `tests` independent tests of which all are to pass with probability 1 -
/// `level` (Sidak, "Rectangular Confidence Regions for the Means of Multivariate Normal
/// Distributions", 1967).
double sidakLevel(double level, std::size_t tests);

}  // namespace laver
