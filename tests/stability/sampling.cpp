// How fast samplers converge at an edge. Each new sampler needs a row here.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "pictures/harness.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::test {
namespace {

/// The half-plane x < 0.2 y of the plane z = 0, seen along z with a box filter; |n| is 1 on it.
constexpr double kSlope = 0.2;
Scene edge(const SamplerRow* sampler, std::uint32_t samples) {
  Scene scene;
  scene.meshes = {gridMesh(
      1, [](double x, double y) { return glm::dvec3(4 * x - 4 + kSlope * 9 * y, 9 * y, 0.0); })};
  scene.camera.toWorld = glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 4, 1);
  scene.camera.width = scene.camera.height = 64;
  scene.sampler = {samples, 0, sampler};
  scene.filter = {&filters::box, 0.5, 0.0, 0.0, 0.0};
  return scene;
}

/// Share of pixel (x, y) that the half-plane covers, from 1,024 rows, each exact at its midpoint.
double coverage(const Camera& camera, int x, int y) {
  const double half = 4.0 * std::tan(camera.fov * std::numbers::pi / 360.0);
  const auto world = [&](double film) { return (1.0 - 2.0 * film / camera.width) * half; };
  double sum = 0;
  constexpr int kRows = 1024;
  for (int r = 0; r < kRows; ++r) {
    // Film x and world x have opposite directions, since +x is left in camera space.
    const double border = kSlope * world(y + (r + 0.5) / kRows);
    const double left = world(x), right = world(x + 1);
    sum += std::clamp((border - right) / (left - right), 0.0, 1.0);
  }
  return sum / kRows;
}

double edgeError(const SamplerRow* sampler, std::uint32_t samples) {
  const Scene scene = edge(sampler, samples);
  VulkanOptions vulkan;
  vulkan.device = testDevice();
  const Image image = render(scene, vulkan);
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

struct Theory {
  const SamplerRow* kind;
  double slope;
  const char* text;
  double errorOf16;
};
/// Expected slopes. For n uniform points each has the variance of a coin. Of n cells of area 1/n an
/// edge cuts about sqrt(n), and only those have an error: n^-1/2 n^-1/4. Of 4 x 4 strata this edge
/// cuts about 4.8, each with a variance of 1/6 / 16^2: 0.056. Sobol's nets are strata of every
/// shape at once.
constexpr std::array kTheories = {Theory{&samplers::independent, -0.5, "-1/2", 0.084},
                                  Theory{&samplers::stratified, -0.75, "-3/4", 0.056},
                                  Theory{&samplers::sobol, -0.75, "-3/4", 0.037}};

LAVER_STABILITY(Sampling, "Sampler slopes at an edge") {
  const std::uint32_t few = 16, many = full ? 4096 : 1024;
  std::optional<double> plain;  // slope of `independent`, the naive method for the others
  for (const Theory& theory : kTheories) {
    const double errorOfFew = edgeError(theory.kind, few);
    const double slope = std::log(edgeError(theory.kind, many) / errorOfFew) / std::log(many / few);
    std::optional<double> naive;
    if (plain) naive = std::abs(*plain - theory.slope);
    record.add({fmt::format("{}: slope {:.2f}, theory {}", theory.kind->name, slope, theory.text),
                "renderer", many, naive, std::abs(slope - theory.slope), 0.1, "off theory"});
    EXPECT_NEAR(errorOfFew, theory.errorOf16, 0.25 * theory.errorOf16) << theory.kind->name;
    if (!plain) plain = slope;
  }
}

}  // namespace
}  // namespace laver::test
