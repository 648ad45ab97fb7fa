#include "lab/chart/errors.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "image/compare.h"
#include "lab/explain/bounds.h"
#include "render/tiling.h"

namespace laver::chart {
namespace {

/// Largest difference of a pixel's channels; NaN differs from everything.
double distanceAt(const Image& a, const Image& b, int x, int y) {
  double largest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto value = static_cast<double>(b.at(x, y, c));
    const double d =
        std::abs(static_cast<double>(a.at(x, y, c)) - value) / std::max(1.0, std::abs(value));
    largest = std::isnan(d) ? std::numeric_limits<double>::infinity() : std::max(largest, d);
  }
  return largest;
}

/// A pixel is explained if one of the samples that its filter reaches would see something else a
/// float's rounding away: the bound of explain/bounds.h for the nearest hit, and as much again for
/// the shadow ray's end. One sample that flips changes the pixel by no more than itself; half,
/// because what lies beyond the edge is shaded a little differently there.
bool explained(const Scene& scene, const Reference& reference, const BoundsOf& bounds, int x, int y,
               double difference) {
  const int apron = static_cast<int>(apronOf(scene.filter.radius));
  for (int v = std::max(y - apron, 0); v <= std::min(y + apron, scene.camera.height - 1); ++v)
    for (int u = std::max(x - apron, 0); u <= std::min(x + apron, scene.camera.width - 1); ++u)
      for (std::uint32_t s = 0; s < scene.sampler.sampleCount; ++s) {
        const glm::dvec2 film(reference.samplePosition(u, v, s));
        const auto hit = reference.centre(film);
        const double delta = hit ? 2.0 * bounds.pixelsAt(hit->distance) : 0.004;
        if (!reference.decided(film, delta, 0.5 * difference)) return true;
      }
  return false;
}

}  // namespace

Image rgbOf(const Image& image, const std::string& file) {
  Image rgb = rgbImage(image.width, image.height);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto found = std::find(image.channels.begin(), image.channels.end(), rgb.channels[c]);
    if (found == image.channels.end())
      throw Error(ExitCode::Usage, "\"" + file + "\" has no channel " + rgb.channels[c]);
    const auto from = static_cast<std::size_t>(found - image.channels.begin());
    for (std::size_t i = 0; i < rgb.pixels.size() / 3; ++i)
      rgb.pixels[i * 3 + c] = image.pixels[i * image.channels.size() + from];
  }
  return rgb;
}

Errors errorsOf(const Image& image, const Image& truth) {
  Errors errors;
  const auto channels = compare(image, truth, 0.0);
  const auto n = static_cast<double>(channels.size());
  for (const ChannelDifference& c : channels) {
    errors.rmse += c.rmse * c.rmse / n;
    errors.relativeMse += c.relativeMse / n;
  }
  errors.rmse = std::sqrt(errors.rmse);
  return errors;
}

Mismatches mismatchesOf(const Image& image, const Image& truth, const Scene& scene,
                        const Reference& reference, unsigned threads) {
  Mismatches result;
  result.rmse = errorsOf(image, truth).rmse;
  const BoundsOf bounds(scene);
  const auto width = static_cast<std::size_t>(image.width);
  std::atomic<std::uint64_t> pixels = 0, unexplained = 0;
  parallelFor(width * static_cast<std::size_t>(image.height), 16, threads,
              [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                  const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
                  const double d = distanceAt(image, truth, x, y);
                  if (d <= kMismatch) continue;
                  ++pixels;
                  if (!explained(scene, reference, bounds, x, y, d)) ++unexplained;
                }
              });
  result.pixels = pixels;
  result.unexplained = unexplained;
  return result;
}

}  // namespace laver::chart
