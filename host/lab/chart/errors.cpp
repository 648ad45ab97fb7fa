#include "lab/chart/errors.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "image/compare.h"
#include "lab/explain/judge.h"

namespace laver::chart {

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
  const PixelDifferences found =
      explainPixels(image, truth, Judge(scene, reference), kMismatch, threads);
  return {found.differing, found.unexplained, errorsOf(image, truth).rmse};
}

}  // namespace laver::chart
