#include "lab/explain/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/parallel.h"
#include "render/tiling.h"

namespace laver {
namespace {

using glm::dvec2;
using glm::dvec3;
using reference::Numbers;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The centre and eight steps around it. An edge within one step of the centre separates some of
/// them.
constexpr std::array<dvec2, 9> kAround{dvec2(0, 0),  dvec2(1, 0),  dvec2(-1, 0),
                                       dvec2(0, 1),  dvec2(0, -1), dvec2(1, 1),
                                       dvec2(1, -1), dvec2(-1, 1), dvec2(-1, -1)};

/// Distance of the nearest hit, from every fourth pixel of every fourth row.
double nearestOf(const Camera& camera, const Reference& reference) {
  double nearest = kInfinity;
  for (int y = 0; y < camera.height; y += 4)
    for (int x = 0; x < camera.width; x += 4)
      if (const auto hit = reference.closest(dvec2(x, y) + 0.5))
        nearest = std::min(nearest, hit->distance);
  return nearest;
}

bool drawsDirections(const Scene& scene) { return scene.integrator.row->needs.numbers; }

/// The largest difference in a channel that exceeds `tolerance` * max(1, |wanted|), else 0. NaN
/// differs from everything.
double differenceOf(dvec3 got, dvec3 wanted, double tolerance) {
  double largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    const double d = std::abs(got[c] - wanted[c]);
    if (d <= tolerance * std::max(1.0, std::abs(wanted[c]))) continue;
    largest = std::isnan(d) ? kInfinity : std::max(largest, d);
  }
  return largest;
}

dvec3 pixelOf(const Image& image, int x, int y) {
  return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
}

/// Whether a sample that the filter of a pixel reaches satisfies `wanted`.
template <class Wanted>
bool anySample(const Scene& scene, const Reference& reference, int x, int y, const Wanted& wanted) {
  const int apron = static_cast<int>(apronOf(scene.filter.radius));
  for (int v = std::max(y - apron, 0); v <= std::min(y + apron, scene.camera.height - 1); ++v)
    for (int u = std::max(x - apron, 0); u <= std::min(x + apron, scene.camera.width - 1); ++u)
      for (std::uint32_t s = 0; s < scene.sampler.sampleCount; ++s)
        if (wanted(dvec2(reference.samplePosition(u, v, s)), reference.sampleNumbers(u, v, s)))
          return true;
  return false;
}

}  // namespace

Judge::Judge(const Scene& scene, const Reference& reference)
    : scene_(scene),
      reference_(reference),
      rounding_(scene),
      nearest_(nearestOf(scene.camera, reference)) {}

// The nearest hit of the rays around: rounding may move the edge of a near object to where the
// centre ray hits something far.
double Judge::nearestDistance(dvec2 film) const {
  const double step = rounding_.ofHit(film, nearest_);
  double nearest = kInfinity;
  for (const dvec2 around : kAround)
    if (const auto hit = reference_.closest(film + step * around))
      nearest = std::min(nearest, hit->distance);
  return nearest;
}

bool Judge::otherHit(dvec2 film) const {
  const double step = rounding_.ofHit(film, nearestDistance(film));
  const auto idAt = [&](dvec2 around) {
    const auto hit = reference_.closest(film + step * around);
    return hit ? std::optional(hit->triangle) : std::nullopt;
  };
  const auto own = idAt(kAround[0]);
  return std::ranges::any_of(kAround, [&](dvec2 around) { return idAt(around) != own; });
}

bool Judge::mayHit(dvec2 film, std::optional<std::uint32_t> id, double distance) const {
  const double step = rounding_.ofHit(film, std::min(distance, nearestDistance(film)));
  return std::ranges::any_of(kAround, [&](dvec2 around) {
    const auto hit = reference_.closest(film + step * around);
    return hit ? id == hit->triangle : !id;
  });
}

bool Judge::otherValue(dvec2 film, const Numbers& numbers, double difference) const {
  const dvec3 own = reference_.radiance(film, numbers);
  const auto differs = [&](dvec2 atFilm, const Numbers& atNumbers) {
    return differenceOf(reference_.radiance(atFilm, atNumbers), own, 0.0) > difference;
  };
  const double near = nearestDistance(film);
  const double step =
      near == kInfinity ? rounding_.ofBackground(film) : rounding_.ofShading(film, near);
  const bool explained = std::ranges::any_of(kAround, [&](dvec2 around) {
    return differs(film + step * around, numbers) ||
           (drawsDirections(scene_) && differs(film, numbers.moved(Rounding::kDirection * around)));
  });
  // Shadows of far blockers move farther, and theirs only.
  for (double far = near; !explained && near < kInfinity && far < rounding_.farthestBlocker();
       far *= 2.0) {
    const double wider = rounding_.ofShading(film, near, 2.0 * far);
    const bool blocked = reference_.blockerDistance(film) >= far;
    if (std::ranges::any_of(kAround, [&](dvec2 around) {
          const dvec2 place = film + wider * around;
          return differs(place, numbers) && (blocked || reference_.blockerDistance(place) >= far);
        }))
      return true;
  }
  return explained;
}

bool Judge::pixelSeesOtherHit(int x, int y) const {
  return anySample(scene_, reference_, x, y,
                   [&](dvec2 film, const Numbers&) { return otherHit(film); });
}

bool Judge::explainsPixel(int x, int y, double difference) const {
  return anySample(scene_, reference_, x, y, [&](dvec2 film, const Numbers& numbers) {
    return otherValue(film, numbers, 0.5 * difference);
  });
}

PixelDifferences explainPixels(const Image& image, const Image& truth, const Judge& judge,
                               double tolerance, unsigned threads) {
  enum class Found : std::uint8_t { Same, Explained, Unexplained };
  const auto width = static_cast<std::size_t>(image.width);
  std::vector<Found> found(width * static_cast<std::size_t>(image.height));
  const auto differenceAt = [&](std::size_t i) {
    const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
    return differenceOf(pixelOf(image, x, y), pixelOf(truth, x, y), tolerance);
  };
  parallelFor(found.size(), 16, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double difference = differenceAt(i);
      if (difference == 0.0) continue;
      const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
      found[i] = judge.explainsPixel(x, y, difference) ? Found::Explained : Found::Unexplained;
    }
  });
  PixelDifferences result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (found[i] == Found::Same) continue;
    ++result.differing;
    if (found[i] == Found::Unexplained && result.unexplained++ == 0)
      result.first =
          fmt::format("pixel {}, {} differs by {:.3g}", i % width, i / width, differenceAt(i));
  }
  return result;
}

}  // namespace laver
