// How fast samplers converge at an edge. A sampler that is added gets a row of its own here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/harness.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::stability {
namespace {

/// Half-plane x < 0.2 y of the plane z = 0, seen along z by box filter; |n| is 1 there.
constexpr double kSlope = 0.2;
Scene edge(std::uint32_t samples) {
  Scene scene;
  scene.meshes = {gridMesh(
      1, [](double x, double y) { return glm::dvec3(4 * x - 4 + kSlope * 9 * y, 9 * y, 0.0); })};
  scene.camera.toWorld = glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 4, 1);
  scene.camera.width = scene.camera.height = 64;
  scene.sampler.sampleCount = samples;
  scene.filter = {Filter::Kind::Box, 0.5, 0.0, 0.0, 0.0};
  return scene;
}

/// Share of pixel (x, y) that the half-plane covers, by the midpoints of 1,024 rows, each exact.
double coverage(const Camera& camera, int x, int y) {
  const double half = 4.0 * std::tan(camera.fov * std::numbers::pi / 360.0);
  const auto world = [&](double film) { return (1.0 - 2.0 * film / camera.width) * half; };
  double sum = 0;
  constexpr int kRows = 1024;
  for (int r = 0; r < kRows; ++r) {
    // Film x runs against world x, which +x left makes.
    const double border = kSlope * world(y + (r + 0.5) / kRows);
    const double left = world(x), right = world(x + 1);
    sum += std::clamp((border - right) / (left - right), 0.0, 1.0);
  }
  return sum / kRows;
}

double edgeError(std::uint32_t samples) {
  const Scene scene = edge(samples);
  VulkanOptions vulkan;
  vulkan.device = testDevice();
  const Image image = test::render(scene, vulkan);
  double squares = 0;
  int count = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const double truth = coverage(scene.camera, x, y);
      if (truth == 0.0 || truth == 1.0) continue;
      squares += std::pow(static_cast<double>(image.at(x, y, 2)) - truth, 2);
      ++count;
    }
  EXPECT_GT(count, 60);
  return std::sqrt(squares / count);
}

LAVER_STABILITY(17, Sampling, "Sampler slopes at an edge") {
  const std::uint32_t few = 16, many = full ? 4096 : 1024;
  const double slope = std::log(edgeError(many) / edgeError(few)) / std::log(many / few);
  record.add({fmt::format("independent: slope {:.2f}, theory -1/2", slope), "renderer", many,
              std::nullopt, std::abs(slope + 0.5), 0.1, "off theory"});
  EXPECT_NEAR(edgeError(few), 0.084, 0.02);  // the theory's constant for uniform coverage
}

}  // namespace
}  // namespace laver::stability
