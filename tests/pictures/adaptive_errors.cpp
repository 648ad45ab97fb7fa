// The error of adaptive sampling: no bias, the requested size, and fewer samples than without it.
#include <cmath>
#include <numbers>

#include "pictures/adaptive.h"

namespace laver::test {
namespace {

/// A film of `side` x `side` pixels with a square of 0.1 x 0.1 pixels at the centre of each: |n| is
/// 1 in exactly 1 % of the area.
Scene specks(int side) {
  Scene scene;
  scene.meshes.resize(1);
  Mesh& mesh = scene.meshes[0];
  scene.camera.toWorld = glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 4, 1);
  scene.camera.width = scene.camera.height = side;
  const double half = 4.0 * std::tan(scene.camera.fov * std::numbers::pi / 360.0);
  const auto world = [&](double film) { return (1.0 - 2.0 * film / side) * half; };
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto first = static_cast<unsigned>(mesh.positions.size());
      for (const auto& [dx, dy] : {std::pair(0.45, 0.45), std::pair(0.55, 0.45),
                                   std::pair(0.55, 0.55), std::pair(0.45, 0.55)})
        mesh.positions.emplace_back(world(x + dx), world(y + dy), 0.0);
      mesh.triangles.emplace_back(first, first + 1, first + 2);
      mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
  scene.filter = {&filters::box, 0.5, 0.0, 0.0, 0.0};
  scene.sampler.sampleCount = 256;
  return scene;
}

/// The mean of `seeds` pictures divided by the true mean, and its standard error.
std::pair<double, double> meanOfSpecks(int side, int seeds) {
  Scene scene = specks(side);
  double sum = 0, variance = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    scene.sampler.seed = 1000 + seed;
    const Adaptive ours = renderTo(scene, adaptive(0.03));
    EXPECT_GT(ours.stats.max, 2 * ours.stats.min);
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x) {
        sum += static_cast<double>(ours.image.at(x, y, 2));
        variance += 0.01 * 0.99 / static_cast<double>(ours.stats.samples.at(x, y, 0));
      }
  }
  const double pixels = static_cast<double>(side) * side * seeds;
  return {sum / pixels / 0.01, std::sqrt(variance) / pixels / 0.01};
}

TEST(Adaptive, SpecksOfOnePercentKeepTheirMean) {
  const auto [mean, error] = meanOfSpecks(64, 6);
  EXPECT_LT(error, 0.03);
  EXPECT_NEAR(mean, 1.0, 3.5 * error);
}

TEST(FullAdaptive, SpecksOfOnePercentKeepTheirMeanToAFifthOfAPercent) {
  const auto [mean, error] = meanOfSpecks(512, 44);
  EXPECT_LT(error, 0.001);
  EXPECT_NEAR(mean, 1.0, 0.002);
}

/// The error, against a converged picture, of the pixels with more than the minimum of samples.
TEST(Adaptive, TheErrorIsTheRequestedOne) {
  Scene scene = floorScene();
  scene.sampler.sampleCount = 512;
  constexpr double kWanted = 0.005;
  const Adaptive ours = renderTo(scene, adaptive(kWanted));
  Scene converged = scene;
  converged.sampler.sampleCount = 1024;
  converged.sampler.seed = 5;
  const Image truth = render(converged);
  double squares = 0, all = 0;
  int count = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      const auto d = static_cast<double>(ours.image.at(x, y, 0) - truth.at(x, y, 0));
      all += d * d;
      if (ours.stats.samples.at(x, y, 0) <= 4.0F) continue;
      squares += d * d;
      ++count;
    }
  EXPECT_GT(count, 300);
  // Steps of four samples and a quarter of the neighbours' counts give cells more samples than they
  // need.
  EXPECT_LT(std::sqrt(squares / count), 1.1 * kWanted);
  EXPECT_GT(std::sqrt(squares / count), 0.3 * kWanted);
  EXPECT_LT(std::sqrt(all / (96 * 96)), kWanted);
}

double rmse(const Image& a, const Image& b) {
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const auto d = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
    squares += d * d;
  }
  return std::sqrt(squares / static_cast<double>(a.pixels.size()));
}

TEST(Adaptive, NeedsLessThanHalfOfTheRaysOfPlainSobol) {
  Scene scene = floorScene(192);
  const auto errorOf = [&](const SamplerRow* kind, std::uint32_t samples, const Image& truth) {
    scene.sampler = {samples, 0, kind};
    return rmse(render(scene), truth);
  };
  scene.sampler = {512, 99, &samplers::sobol};
  const Image truth = render(scene);
  scene.sampler = {4096, 0, &samplers::sobol};
  const Adaptive ours = renderTo(scene, adaptive(0.0045));
  const double wanted = errorOf(&samplers::independent, 64, truth);
  EXPECT_LT(rmse(ours.image, truth), wanted);
  const double rays =
      ours.stats.average + static_cast<double>(ours.stats.pilotSamples) / (192.0 * 192.0);
  EXPECT_GT(errorOf(&samplers::sobol, static_cast<std::uint32_t>(2.0 * rays), truth), wanted);
}

}  // namespace
}  // namespace laver::test
