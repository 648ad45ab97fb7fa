#include "lab/chart/truth.h"

#include <fmt/format.h>

#include <algorithm>

#include "image/noise_test.h"
#include "reference/reference.h"

namespace laver::chart {
namespace {

/// A false alarm costs minutes: one chart in a thousand has one.
constexpr NoiseLimits kLimits = {.significance = 0.001};

Image renderReference(const Scene& scene, const Options& options, Part part,
                      Rows<LayerRow> layers = {}) {
  RenderOptions render;
  render.threads = options.threads;
  render.observers = {&part};
  render.layers = std::move(layers);
  Image image = Reference(scene, options.threads).render(render).image;
  throwIfStopped(options);
  return image;
}

Image meanOf(const Image& a, const Image& b) {
  Image mean = a;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    mean.pixels[i] = 0.5F * (a.pixels[i] + b.pixels[i]);
  return mean;
}

Truth byReference(Scene scene, const Options& options) {
  scene.sampler.row = &samplers::stratified;
  scene.sampler.sampleCount = options.truthSamples;
  scene.sampler.seed += 1;
  const Image a = renderReference(scene, options, {options, 0.0, kTruthEnd / 2});
  scene.sampler.seed += 1;
  const Image b = renderReference(scene, options, {options, kTruthEnd / 2, kTruthEnd});
  return {meanOf(a, b), errorsOf(a, b).rmse / 2.0, "double precision"};
}

/// By the device: `more` follows its number of samples and its seed.
Image byDevice(const Scene& scene, const Options& options, const Measurement& measurement,
               std::int64_t seed, const std::vector<std::string>& more) {
  std::vector<std::string> all = {"--spp", std::to_string(options.truthSamples), "--seed",
                                  std::to_string(scene.sampler.seed + seed)};
  all.insert(all.end(), more.begin(), more.end());
  return measurement.render(all);
}

/// Means of blocks of 8 x 8 pixels, and their variances, where pixels share no samples. Single
/// pixels have too few samples for normal sums.
Image blocksOf(const Image& image) {
  constexpr int kBlock = 8;
  const std::size_t channels = image.channels.size();
  Image blocks = blackImage((image.width + kBlock - 1) / kBlock,
                            (image.height + kBlock - 1) / kBlock, image.channels);
  for (int y = 0; y < blocks.height; ++y)
    for (int x = 0; x < blocks.width; ++x) {
      const int right = std::min((x + 1) * kBlock, image.width);
      const int bottom = std::min((y + 1) * kBlock, image.height);
      const double count = (right - x * kBlock) * (bottom - y * kBlock);
      for (std::size_t c = 0; c < channels; ++c) {
        double sum = 0.0;
        for (int v = y * kBlock; v < bottom; ++v)
          for (int u = x * kBlock; u < right; ++u) sum += double{image.at(u, v, c)};
        const bool variance = image.channels[c].starts_with("variance.");
        blocks.at(x, y, c) = static_cast<float>(sum / (variance ? count * count : count));
      }
    }
  return blocks;
}

/// Whether the device's picture, with the box filter, is that of double precision with `samples`
/// per pixel.
NoiseTest testDevice(Scene scene, const Options& options, const Measurement& measurement,
                     std::uint32_t samples) {
  const Image device = byDevice(scene, options, measurement, 3,
                                {"--sampler", samplers::independent.name, "--filter",
                                 filters::box.name, "--layers", layers::variance.name});
  scene.sampler.row = &samplers::independent;
  scene.sampler.sampleCount = samples;
  scene.sampler.seed += 4;
  scene.filter = filterOf(filters::box);
  const Image reference =
      renderReference(scene, options, {options, 0.0, kTruthEnd}, {&layers::variance});
  return testNoise(blocksOf(device), blocksOf(reference), kLimits, 0);
}

}  // namespace

Truth truthOf(const Scene& scene, const Options& options, const Measurement& measurement) {
  if (!scene.integrator.row->bounces) return byReference(scene, options);
  const std::uint32_t samples = std::max(options.truthSamples / 16, 2U);
  const NoiseTest test = testDevice(scene, options, measurement, samples);
  const std::string finding = fmt::format(
      "{:.4g} % of the blocks of 8 x 8 pixels agree, means differ by {:.2g} %, p {:.2g}",
      100.0 * test.agree, 100.0 * test.meanDifference, test.meanP);
  if (!test.passed) {
    if (options.say)
      options.say("The device's picture is not that of double precision, which renders it anew: " +
                  finding);
    return byReference(scene, options);
  }
  const std::vector<std::string> stratified = {"--sampler", samplers::stratified.name};
  const std::string file = "converged picture";
  const Image a = rgbOf(byDevice(scene, options, measurement, 1, stratified), file);
  const Image b = rgbOf(byDevice(scene, options, measurement, 2, stratified), file);
  return {meanOf(a, b), errorsOf(a, b).rmse / 2.0,
          fmt::format("the device, equal to double precision with {} samples per pixel by a z-test "
                      "({})",
                      samples, finding)};
}

}  // namespace laver::chart
