// Reconstruction filters against the same sums in double: a flat field stays flat, a step keeps its
// position, and negative lobes are normalised.
#include <gtest/gtest.h>

#include "pictures/harness.h"
#include "reference/reference.h"
#include "stability/record.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::test {
namespace {

/// A square that faces the camera; the film shows its inside if `flat`, else its slanted edge.
Scene square(Filter filter, bool flat) {
  Scene scene;
  scene.meshes = {gridMesh(1, [&](double x, double y) {
    return flat ? glm::dvec3(9 * x, 9 * y, 0.0) : glm::dvec3(2 * x - 2 + 0.2 * y, 9 * y, 0.0);
  })};
  scene.camera.toWorld = glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0.05, 0.03, 4, 1);
  scene.camera.width = scene.camera.height = 64;
  scene.sampler.sampleCount = 4;
  scene.filter = filter;
  return scene;
}

constexpr std::uint64_t kSamples = 16384;  // 4 for each of 64x64 pixels

double furthest(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(
        largest, std::abs(static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i])));
  return largest;
}

/// How far a flat field is from 1 if sums are divided by the expected weights instead of the actual
/// ones: 4 samples per pixel, tent of radius 1, whose weights have the mean 1.
double unnormalised(const Reference& reference) {
  double largest = 0;
  for (int y = 1; y < 63; ++y)
    for (int x = 1; x < 63; ++x) {
      double sum = 0;
      for (int py = y - 1; py <= y + 1; ++py)
        for (int px = x - 1; px <= x + 1; ++px)
          for (std::uint32_t s = 0; s < 4; ++s) {
            const glm::dvec2 d =
                glm::abs(glm::dvec2(reference.samplePosition(px, py, s)) - glm::dvec2(x, y) - 0.5);
            sum += std::max(0.0, 1 - d.x) * std::max(0.0, 1 - d.y);
          }
      largest = std::max(largest, std::abs(sum / 4 - 1));
    }
  return largest;
}

LAVER_STABILITY(Filters, "Filters: flat field, step, negative lobes") {
  const std::vector<std::pair<const char*, Filter>> filters = {
      {"gaussian", {&filters::gaussian, 2.0, 0.5, 0.0, 0.0}},
      {"Mitchell", {&filters::mitchell, 2.0, 0.5, 1.0 / 3, 1.0 / 3}},
      {"tent", {&filters::tent, 1.0, 0.5, 0.0, 0.0}}};
  for (const auto& [name, filter] : filters)
    for (const std::string traversal : {"lane", "packet32", "packet64"}) {
      VulkanOptions vulkan;
      vulkan.device = testDevice();
      vulkan.traversal = traversal;
      const Scene flat = square(filter, true);
      Image ones = rgbImage(64, 64);
      for (std::size_t i = 2; i < ones.pixels.size(); i += 3) ones.pixels[i] = 1.0F;
      const Image field = render(flat, vulkan);
      record.add({std::string(name) + ", flat field", traversal, kSamples,
                  unnormalised(Reference(flat)), furthest(field, ones), 1e-6, "of the field"});

      const Scene step = square(filter, false);
      const Reference reference(step);
      RenderOptions compat;
      compat.noriCompat = true;
      record.add({std::string(name) + ", step; naive: Nori's table", traversal, kSamples,
                  furthest(test::render(step, vulkan, compat), reference.render().image),
                  furthest(test::render(step, vulkan), reference.render().image), 1e-6,
                  "of the step"});
    }
}

}  // namespace
}  // namespace laver::test
