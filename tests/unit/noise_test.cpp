// The test of whether noise explains the difference between two pictures: its size, its power and
// its errors.
#include "image/noise_test.h"

#include <gtest/gtest.h>

#include <random>

#include "core/error.h"

namespace laver::test {
namespace {

/// Grey pictures of mean 1 with normally distributed noise, and their variance.
class Noisy {
 public:
  Image picture(double mean = 1.0) {
    Image image = blackImage(40, 30, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] = static_cast<float>(i % 6 < 3 ? mean + 0.1 * normal_(random_) : 0.01);
    return image;
  }

 private:
  std::mt19937 random_{5};
  std::normal_distribution<double> normal_;
};

TEST(NoiseTest, EqualExpectationsFailAsOftenAsTheSignificanceSays) {
  Noisy noisy;
  // Each of the two tests has half of the significance: with 0.1, it fails in 10 of 200, with a
  // standard deviation of 3. The three channels are independent here.
  int byMeans = 0, byPixels = 0;
  for (int i = 0; i < 200; ++i) {
    const NoiseTest test = testNoise(noisy.picture(), noisy.picture(), {0.1, 1.0}, 2);
    byMeans += test.meanP < 0.05 ? 1 : 0;
    byPixels += test.smallest < 0.05 ? 1 : 0;
    EXPECT_EQ(test.passed, test.meanP >= 0.05 && test.smallest >= 0.05);
    EXPECT_EQ(test.pixels, 1200U);
  }
  EXPECT_NEAR(byMeans, 10, 13);
  EXPECT_NEAR(byPixels, 10, 13);
  EXPECT_GT(byMeans + byPixels, 0);
}

TEST(NoiseTest, ATenthLessLightIsFoundByTheMeansAlone) {
  // The difference of two pixels has a standard deviation of 0.14, and its mean over the 48 pixels
  // that share no samples one of 0.02. A tenth is five of these, but less than one of a pixel's.
  Noisy noisy;
  for (int i = 0; i < 20; ++i) {
    const NoiseTest test = testNoise(noisy.picture(0.90), noisy.picture(), {}, 2);
    EXPECT_FALSE(test.passed);
    EXPECT_GE(test.agree, 0.9975);
    EXPECT_NEAR(test.meanDifference, -0.1, 0.08);
  }
}

TEST(NoiseTest, OnePixelIsFoundByItsOwn) {
  Noisy noisy;
  Image a = noisy.picture();
  const Image b = noisy.picture();
  for (int i = 0; i < 4; ++i) a.at(7 + 2 * i, 11, 1) += 1.0F;
  const NoiseTest test = testNoise(a, b, {}, 2);
  EXPECT_FALSE(test.passed);
  EXPECT_NEAR(test.agree, 1.0 - 4.0 / 1200.0, 1e-12);
  EXPECT_LT(test.p[11 * 40 + 7], 1e-3);
  EXPECT_TRUE(testNoise(a, b, {.pass = 0.99}, 2).passed);
}

TEST(NoiseTest, ValuesThatAreNotFiniteOrHaveNoVarianceDiffer) {
  Noisy noisy;
  const Image a = noisy.picture();
  Image b = a;
  EXPECT_TRUE(testNoise(a, b, {.pass = 1.0}, 2).passed);
  b.at(3, 3, 0) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(testNoise(a, b, {}, 2).p[3 * 40 + 3], 0.0);
  b = a;
  Image c = a;
  for (Image* image : {&b, &c}) image->at(3, 3, 3) = 0.0F;
  b.at(3, 3, 0) = c.at(3, 3, 0) + 0.1F;
  EXPECT_LT(testNoise(b, c, {}, 2).p[3 * 40 + 3], 1e-6);
}

TEST(NoiseTest, LackingVariancesAreNamed) {
  Noisy noisy;
  const Image a = noisy.picture();
  try {
    testNoise(a, rgbImage(40, 30), {}, 2);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "--noise needs the channels R, G, B and variance.R, variance.G, variance.B in both "
              "pictures, variance.R is missing: render with --layers variance");
  }
}

}  // namespace
}  // namespace laver::test
