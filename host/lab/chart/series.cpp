#include <fmt/format.h>

#include "kernels/keys.h"
#include "lab/chart/chart.h"
#include "scene/samplers.h"

namespace laver::chart {
namespace {

constexpr double kErrors[] = {0.04, 0.02, 0.01, 0.005};
/// Samples per pixel: so many that --error decides how many are taken.
constexpr const char* kAdaptiveLimit = "1024";

}  // namespace

std::vector<Series> seriesFor(const std::string& chosen, const std::vector<Peer>& peers) {
  const std::string independent = samplers::independent.name;
  std::vector<Series> all;
  for (const SamplerRow* sampler : samplerRows())
    all.push_back({sampler->name, "laver", sampler->name, false, "", {}});
  for (const SamplerRow* sampler : samplerRows())
    if (sampler->adaptive)
      all.push_back(
          {fmt::format("{}, adaptive", sampler->name), "laver", sampler->name, true, "", {}});
  // Devices for which laver chooses `lane` may support no other traversal.
  for (const Traversal traversal : {Traversal::Lane, Traversal::Packet32, Traversal::Packet64})
    if (chosen != traversalName(Traversal::Lane) && chosen != traversalName(traversal))
      all.push_back({fmt::format("{}, {}", independent, traversalName(traversal)),
                     "laver",
                     independent,
                     false,
                     traversalName(traversal),
                     {}});
  for (const Peer& peer : peers) all.push_back({peer.name, peer.name, independent, false, "", {}});
  return all;
}

std::vector<std::string> stepOptions(const Series& series, std::size_t step,
                                     std::uint32_t maxSamples) {
  std::vector<std::string> options{"--sampler", series.sampler};
  if (series.adaptive) {
    if (step >= std::size(kErrors)) return {};
    options.insert(options.end(),
                   {"--error", fmt::format("{}", kErrors[step]), "--spp", kAdaptiveLimit});
    return options;
  }
  const std::uint64_t samples = std::uint64_t{1} << std::min<std::size_t>(2 * step, 40);
  if (samples > maxSamples) return {};
  options.insert(options.end(), {"--spp", std::to_string(samples)});
  if (!series.traversal.empty()) options.insert(options.end(), {"--traversal", series.traversal});
  return options;
}

}  // namespace laver::chart
