#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"
#include "render/packed.h"
#include "render/rendered.h"
#include "render/sample_map.h"

namespace laver {

struct FrameWork;
struct RenderTimes;

/// Statistics of adaptive sampling; error 0 if it was off.
struct AdaptiveStats {
  double error = 0;                ///< requested
  std::uint64_t pilotSamples = 0;  ///< not part of the picture
  double average = 0;              ///< samples per pixel, without pilots
  std::uint32_t min = 0, max = 0;
  double atBound = 0;  ///< share of pixels with the maximum, --spp
  Image samples;       ///< samples of each pixel; channel `samples`

  /// Of strips, each of which has a map.
  void describe(std::span<const SampleMap> maps, const std::vector<Strip>& strips,
                std::uint32_t bound);
};

/// The statistics of a render for --stats, recorded from events. Seconds are of the host's clock;
/// concurrent parts overlap.
struct Stats {
  struct Seconds {
    double vulkanStart = 0, load = 0, build = 0, upload = 0, compile = 0, trace = 0;
    double reconstruct = 0, readBack = 0, write = 0, total = 0;
  } seconds;
  std::string device, driver, traversal;
  std::uint64_t triangles = 0, collapsedTriangles = 0, droppedTriangles = 0;
  std::uint64_t nodes = 0, leaves = 0, nodeBytes = 0, triangleBytes = 0, attributeBytes = 0;
  std::uint64_t imageBytes = 0, uvBytes = 0;
  std::uint32_t depth = 0, stack = 0;
  double sahCost = 0;
  std::uint32_t passes = 0, bands = 0, samplesPerPass = 0;
  std::uint64_t samples = 0, droppedSamples = 0;
  double coverage = 1;  ///< share of the pixels that the scene covers; others are not traced
  AdaptiveStats adaptive;
  std::uint64_t peakBytes = 0;       ///< of the process, including the memory of a CPU device
  std::vector<std::string> modules;  ///< per kernel: embedded, cached or compiled
  std::vector<Reason> reasons;       ///< of the choices

  void add(const Scene& scene, const Choices& choices, const Packed& packed);
  void add(const FrameWork& work, const RenderTimes& times, const Rendered& rendered);
  nlohmann::json json() const;
  std::string text() const;
};

/// One line of --stats and `laver plan`.
std::string textOf(const Reason& reason);
nlohmann::json jsonOf(const Reason& reason);

}  // namespace laver
