// A point light at any height above, on and below a surface: every sample is finite and as close to
// the truth as the rounding of the surface's points allows.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pictures/harness.h"
#include "reference/reference.h"
#include "reference/rounding.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::test {
namespace {

/// A floor of half-width 1 under a light at `height`, seen from 2 above by a film that spans some
/// heights, with one sample per pixel.
Scene floorUnder(double height) {
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.meshes = {gridMesh(4, [](double x, double y) { return glm::dvec3(x, y, 0.0); })};
  scene.camera.width = scene.camera.height = 64;
  // Looks along -z, slightly off the light's axis.
  scene.camera.toWorld = glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0.1, 0.05, 2, 1);
  const double span = std::clamp(8.0 * std::abs(height), 1e-6, 0.9);
  scene.camera.toWorld[3] = glm::dvec4(0.1 * span, 0.05 * span, 2.0, 1.0);
  scene.camera.fov = 2.0 * std::atan(0.5 * span) * 180.0 / std::numbers::pi;
  scene.filter = {&filters::box, 0.5, 0.0, 0.0, 0.0};
  scene.lights = {{glm::dvec3(0.0, 0.0, height), glm::dvec3(1.0)}};
  return scene;
}

/// A renderer without guards: cos / d^2 in float at the exact points.
std::uint64_t naiveNotFinite(const Scene& scene, const Reference& reference) {
  std::uint64_t count = 0;
  for (int y = 0; y < scene.camera.height; ++y)
    for (int x = 0; x < scene.camera.width; ++x) {
      const auto hit = reference.closest(glm::dvec2(reference.samplePosition(x, y, 0)));
      if (!hit) continue;
      const auto& mesh = scene.meshes[0];
      const glm::uvec3 t = mesh.triangles[hit->triangle];
      const auto u = static_cast<float>(hit->u), v = static_cast<float>(hit->v);
      const glm::vec3 p = glm::vec3(mesh.positions[t.x]) * (1 - u - v) +
                          glm::vec3(mesh.positions[t.y]) * u + glm::vec3(mesh.positions[t.z]) * v;
      const glm::vec3 direction = glm::vec3(scene.lights[0].position) - glm::vec3(0, 0, p.z);
      const float squared = glm::dot(direction, direction);
      count += std::isfinite(direction.z / std::sqrt(squared) / squared) ? 0 : 1;
    }
  return count;
}

LAVER_STABILITY(Lights, "A light at height 1 to 0, on and behind the surface") {
  std::uint64_t pixels = 0, naive = 0, notFinite = 0, lit = 0, beyond = 0;
  double worst = 0;
  for (const std::string traversal : {"lane", "packet32", "packet64"}) {
    pixels = naive = notFinite = lit = beyond = 0;
    worst = 0;
    for (const double height : {1.0, 0.1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-12, 1e-20, 1e-25,
                                1e-30, 1e-40, 0.0, -1e-25, -1e-8, -1e-3, -1.0}) {
      const Scene scene = floorUnder(height);
      VulkanOptions vulkan;
      vulkan.device = testDevice();
      vulkan.traversal = traversal;
      Stats stats;
      const Image image = Renderer(vulkan).render(scene, {}, stats).image;
      const Reference reference(scene);
      // The camera looks at the floor at a right angle; its corners are at most sqrt(6) away.
      const double deltaP =
          Rounding(scene).sideways(glm::dvec2(32.0), 2.0, std::sqrt(6.0), std::sqrt(3.0));
      notFinite += stats.droppedSamples;
      naive += naiveNotFinite(scene, reference);
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
          ++pixels;
          const auto value = static_cast<double>(image.at(x, y, 0));
          if (!std::isfinite(value)) {
            ++notFinite;
            continue;
          }
          if (height <= 0.0) {
            beyond += value != 0.0 ? 1 : 0;
            continue;
          }
          const double bound = 4.0 * deltaP / height;
          if (bound > 0.25) continue;  // rounding of the surface's points dominates
          const double truth = reference.radiance(glm::dvec2(reference.samplePosition(x, y, 0))).x;
          const double error = std::abs(value - truth) / truth;
          ++lit;
          beyond += error <= bound ? 0 : 1;
          worst = std::max(worst, error / bound);
        }
    }
    EXPECT_GE(lit, 5U * 64 * 64);
    record.add({"samples that are not finite", traversal, pixels, static_cast<double>(naive),
                static_cast<double>(notFinite), 0.0, "samples"});
    record.add({fmt::format("beyond 4 dp / h; worst {:.2g} of it", worst), traversal, lit,
                std::nullopt, static_cast<double>(beyond), 0.0, "samples"});
  }
}

}  // namespace
}  // namespace laver::test
