#include "render/explain.h"

#include <cmath>
#include <limits>

#include "render/scene_data.h"

namespace laver::test {
namespace {

double difference(const Image& a, const Image& b, int x, int y) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double d =
        std::abs(static_cast<double>(a.at(x, y, c)) - static_cast<double>(b.at(x, y, c)));
    // NaN differs from everything.
    largest =
        d <= largest ? largest : (std::isnan(d) ? std::numeric_limits<double>::infinity() : d);
  }
  return largest;
}

bool nearDecision(const Scene& scene, const Reference& reference, int x, int y, double tolerance) {
  const int apron = static_cast<int>(apronOf(scene.filter.radius));
  for (int dy = -apron; dy <= apron; ++dy)
    for (int dx = -apron; dx <= apron; ++dx) {
      const int px = x + dx, py = y + dy;
      if (px < 0 || py < 0 || px >= scene.camera.width || py >= scene.camera.height) continue;
      for (std::uint32_t s = 0; s < scene.sampler.sampleCount; ++s)
        if (!reference.decided(glm::dvec2(reference.samplePosition(px, py, s)), kDelta, tolerance,
                               glm::dvec2(reference.sampleNumbers(px, py, s))))
          return true;
    }
  return false;
}

}  // namespace

Explanation explain(const Image& image, const Image& truth, const Scene& scene,
                    const Reference& reference, double tolerance) {
  Explanation result;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double d = difference(image, truth, x, y);
      if (d <= tolerance) continue;
      ++result.differing;
      // One sample that flips changes the pixel by no more than it changes itself; half, because
      // the surface beyond the edge is shaded a little differently there.
      if (nearDecision(scene, reference, x, y, 0.5 * d)) continue;
      if (result.unexplained++ == 0)
        result.first = "pixel " + std::to_string(x) + ", " + std::to_string(y) + " differs by " +
                       std::to_string(d);
    }
  return result;
}

}  // namespace laver::test
