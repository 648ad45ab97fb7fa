#include "pictures/explain.h"

#include "pictures/harness.h"
#include "render/packed.h"

namespace laver::test {

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

/// Whether a direction drawn by other numbers, kTurn away, changes the sample.
bool turnMatters(const Reference& reference, glm::dvec2 film, glm::dvec2 numbers,
                 double tolerance) {
  const glm::dvec3 centre = reference.radiance(film, numbers);
  const std::array ways{glm::dvec2(1, 1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(-1, -1)};
  return std::ranges::any_of(ways, [&](glm::dvec2 way) {
    const glm::dvec2 turned = glm::clamp(numbers + kTurn * way, 0.0, 1.0);
    const glm::dvec3 away = glm::abs(reference.radiance(film, turned) - centre);
    return !(away.x <= tolerance && away.y <= tolerance && away.z <= tolerance);
  });
}

bool nearDecision(const Scene& scene, const Reference& reference, double moved, int x, int y,
                  double tolerance) {
  const bool draws = scene.integrator.is(integrators::averageVisibility) ||
                     scene.integrator.is(integrators::ambientOcclusion);
  const int apron = static_cast<int>(apronOf(scene.filter.radius));
  for (int dy = -apron; dy <= apron; ++dy)
    for (int dx = -apron; dx <= apron; ++dx) {
      const int px = x + dx, py = y + dy;
      if (px < 0 || py < 0 || px >= scene.camera.width || py >= scene.camera.height) continue;
      for (std::uint32_t s = 0; s < scene.sampler.sampleCount; ++s) {
        const glm::dvec2 film(reference.samplePosition(px, py, s));
        const glm::dvec2 numbers(reference.sampleNumbers(px, py, s));
        if (!reference.decided(film, moved, tolerance, numbers)) return true;
        if (draws && turnMatters(reference, film, numbers, tolerance)) return true;
      }
    }
  return false;
}

}  // namespace

double movedBy(const Scene& scene, const Reference& reference) {
  const Normalisation space = normalisationOf(scene);
  const glm::dvec3 origin = glm::abs(space.apply(glm::dvec3(scene.camera.toWorld[3])));
  double nearest = std::numeric_limits<double>::infinity();
  for (int y = 0; y < scene.camera.height; y += 4)
    for (int x = 0; x < scene.camera.width; x += 4)
      if (const auto hit = reference.closest({x + 0.5, y + 0.5}))
        nearest = std::min(nearest, hit->t);
  const double far = std::max({origin.x, origin.y, origin.z}) + 1.0;
  const double slope = 16.0 / (1 << 24) * far / (nearest * space.scale);
  const double pixel = 2.0 * std::tan(glm::radians(scene.camera.fov) / 2.0) / scene.camera.width;
  return 2.0 * slope / pixel;
}

Explanation explain(const Image& image, const Image& truth, const Scene& scene,
                    const Reference& reference, double tolerance) {
  Explanation result;
  const double moved = movedBy(scene, reference);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double d = difference(image, truth, x, y);
      if (d <= tolerance) continue;
      ++result.differing;
      // One sample that flips changes the pixel by no more than it changes itself; half, because
      // the surface beyond the edge is shaded a little differently there.
      if (nearDecision(scene, reference, moved, x, y, 0.5 * d)) continue;
      if (result.unexplained++ == 0)
        result.first = "pixel " + std::to_string(x) + ", " + std::to_string(y) + " differs by " +
                       std::to_string(d);
    }
  return result;
}

void expectTraversalsMatch(const Scene& scene, double tolerance) {
  const Image image = render(scene);
  expectSameByAll(image, scene);
  const Reference reference(scene);
  expectExplained(image, reference.render().image, scene, reference, tolerance);
}

}  // namespace laver::test
