#include "lab/explain/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/parallel.h"
#include "lab/explain/samples.h"

namespace laver {
namespace {

using Decisions = Explanation::Decisions;

void count(Decisions& decisions, bool differs, bool explained) {
  decisions.differing += differs ? 1 : 0;
  decisions.explained += differs && explained ? 1 : 0;
}

void add(ExplainedChannel& channel, double ulps, bool within, int x, int y) {
  if (channel.ulps.empty() || ulps > channel.worst) {
    channel.worst = ulps;
    channel.x = x;
    channel.y = y;
  }
  channel.ulps.push_back(ulps);
  channel.unexplained += within ? 0 : 1;
}

/// Histogram: counts of values up to 1, 4, 16 ... ulp.
std::string histogram(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::string text;
  auto from = values.begin();
  for (double edge = 1.0; from != values.end(); edge *= 4.0) {
    const auto to = std::upper_bound(from, values.end(), edge);
    text += fmt::format("  <={:g}: {}", edge, to - from);
    from = to;
  }
  return text;
}

}  // namespace

std::uint64_t Explanation::unexplained() const {
  std::uint64_t sum = hits.unexplained() + occlusion.unexplained();
  for (const ExplainedChannel& c : channels) sum += c.unexplained;
  return sum;
}

Explanation explain(const Scene& scene, const Scene& judged, const VulkanOptions& vulkan) {
  if (scene.integrator.row->bounces)
    throw Error(ExitCode::Usage,
                fmt::format("explain takes integrators whose rays end at the first hit or at what "
                            "occludes it, found {}",
                            scene.integrator.row->name));
  if (scene.camera.row->lens)
    throw Error(ExitCode::Usage, "explain takes pinhole cameras, found a lens");
  const SampleComparison comparison(scene, judged, vulkan);
  const auto width = static_cast<std::size_t>(comparison.width());
  std::vector<ComparedSample> samples(width * static_cast<std::size_t>(comparison.height()));
  parallelFor(samples.size(), 256, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      samples[i] = comparison.at(static_cast<int>(i % width), static_cast<int>(i / width));
  });

  Explanation result;
  for (std::size_t q = 0; q < (comparison.hasValue() ? kQuantities : kValue); ++q)
    result.channels.push_back({.name = kQuantityNames[q]});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const ComparedSample& sample = samples[i];
    const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
    if (sample.leftOut) continue;
    ++result.samples;
    count(result.hits, sample.otherHit, sample.explained);
    count(result.occlusion, sample.otherOcclusion, sample.explained);
    for (std::size_t q = 0; q < result.channels.size(); ++q)
      if (sample.ulps[q] >= 0.0) add(result.channels[q], sample.ulps[q], sample.within[q], x, y);
    if (result.first.empty() && !sample.unexplained.empty())
      result.first = fmt::format("pixel {}, {}: {}", x, y, sample.unexplained);
  }
  for (ExplainedChannel& c : result.channels)
    if (!c.ulps.empty()) c.cause = comparison.causeAt(c.x, c.y);
  return result;
}

std::string describe(const Explanation& e) {
  std::string text = fmt::format("{} samples\n", e.samples);
  text += fmt::format("other hit: {}, {} of them explained\n", e.hits.differing, e.hits.explained);
  text += fmt::format("other occlusion: {}, {} of them explained\n", e.occlusion.differing,
                      e.occlusion.explained);
  for (const ExplainedChannel& c : e.channels)
    text += fmt::format("{} [ulp]:{}\n  beyond the bound: {}; worst {:.3g} at pixel {}, {}: {}\n",
                        c.name, histogram(c.ulps), c.unexplained, c.worst, c.x, c.y, c.cause);
  return text + fmt::format("unexplained: {}{}\n", e.unexplained(),
                            e.unexplained() == 0 ? "" : "; " + e.first);
}

}  // namespace laver
