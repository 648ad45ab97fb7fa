// Hypothesis tests against tabulated quantiles, their own size, and what they find.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "lab/hypothesis/statistics.h"

namespace laver::test {
namespace {

Moments of(std::initializer_list<double> numbers) {
  Moments moments;
  for (const double x : numbers) moments.add(x);
  return moments;
}

TEST(StudentTest, HasThePValuesOfTables) {
  // Mean 3 and variance 2.5 of five numbers: t = (3 - reference) sqrt(5 / 2.5).
  const Moments sample = of({1.0, 2.0, 3.0, 4.0, 5.0});
  EXPECT_DOUBLE_EQ(sample.mean(), 3.0);
  EXPECT_DOUBLE_EQ(sample.variance(), 2.5);
  // The two-sided 5 % quantile of 4 degrees of freedom is 2.776, where the density is 0.034: a
  // half of the last digit is 3.4e-5 on both sides.
  const Tested tested = studentTest(sample, 3.0 - 2.776 / std::sqrt(2.0));
  EXPECT_EQ(tested.freedom, 4);
  EXPECT_NEAR(tested.statistic, 2.776, 1e-9);
  EXPECT_NEAR(tested.p, 0.05, 3.4e-5);
}

TEST(StudentTest, RejectsWhatIsNotFiniteAndASingleNumber) {
  EXPECT_EQ(studentTest(of({1.0, std::nan("")}), 1.0).p, 0.0);
  EXPECT_EQ(studentTest(of({1.0}), 1.0).p, 0.0);
}

TEST(StudentTest, TakesNumbersWithoutNoiseForTheirReferenceToFiveDigits) {
  EXPECT_GT(studentTest(of({0.5, 0.5, 0.5}), 0.500001).p, 0.99);
  EXPECT_LT(studentTest(of({0.5, 0.5, 0.5}), 0.6).p, 1e-3);
}

TEST(ChiSquaredTest, HasThePValuesOfTables) {
  // The 5 % quantile of 1 degree of freedom is 3.841: 100 of 200 expected, x = sqrt(192.05) off. A
  // half of the last digit is 1.5e-5 at a density of 0.03.
  const double off = std::sqrt(3.841 * 50.0);
  const std::vector<double> observed = {100.0 + off, 100.0 - off}, expected = {100.0, 100.0};
  const Tested tested = chiSquaredTest(observed, expected, 5.0);
  EXPECT_EQ(tested.freedom, 1);
  EXPECT_NEAR(tested.statistic, 3.841, 1e-9);
  EXPECT_NEAR(tested.p, 0.05, 1.5e-5);
}

TEST(ChiSquaredTest, PoolsRareCellsAndRejectsSamplesWhereNoneAreExpected) {
  const std::vector<double> expected = {50.0, 45.0, 2.0, 3.0, 0.0};
  EXPECT_EQ(chiSquaredTest(std::vector{50.0, 45.0, 3.0, 2.0, 0.0}, expected, 5.0).freedom, 2);
  EXPECT_DOUBLE_EQ(chiSquaredTest(std::vector{50.0, 45.0, 3.0, 2.0, 0.0}, expected, 5.0).p, 1.0);
  EXPECT_EQ(chiSquaredTest(std::vector{50.0, 45.0, 2.0, 3.0, 1.0}, expected, 5.0).p, 0.0);
  EXPECT_EQ(chiSquaredTest(std::vector{50.0, 50.0}, std::vector{50.0, -50.0}, 5.0).p, 0.0);
  EXPECT_EQ(chiSquaredTest(std::vector{100.0}, std::vector{100.0}, 5.0).p, 0.0);
}

// 2,000 tests of a true hypothesis at 5 %: 100 rejections, 4 standard deviations are 39.
TEST(HypothesisTests, RejectATrueHypothesisAsOftenAsStated) {
  std::mt19937 engine(3);
  std::exponential_distribution<double> noise(1.0);
  std::uniform_int_distribution<int> cell(0, 19);
  int students = 0, chis = 0;
  for (int test = 0; test < 2000; ++test) {
    Moments sample;
    std::vector<double> counts(20), expected(20, 50.0);
    for (int i = 0; i < 1000; ++i) {
      sample.add(noise(engine));
      counts[static_cast<std::size_t>(cell(engine))] += 1.0;
    }
    students += studentTest(sample, 1.0).p < 0.05 ? 1 : 0;
    chis += chiSquaredTest(counts, expected, 5.0).p < 0.05 ? 1 : 0;
  }
  EXPECT_NEAR(students, 100, 39);
  EXPECT_NEAR(chis, 100, 39);
}

TEST(SidakLevel, IsThatOfEachTest) {
  EXPECT_NEAR(std::pow(1.0 - sidakLevel(0.01, 15), 15), 0.99, 1e-12);
  EXPECT_DOUBLE_EQ(sidakLevel(0.01, 1), 0.01);
}

}  // namespace
}  // namespace laver::test
