#include "render/stats.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "render/render.h"

namespace laver {

namespace {

const char* nameOf(ModuleSource source) {
  switch (source) {
    case ModuleSource::Embedded:
      return "embedded";
    case ModuleSource::Cached:
      return "cached";
    case ModuleSource::Compiled:
      break;
  }
  return "compiled";
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

void Stats::add(const Scene& scene, const Choices& choices, const Packed& packed) {
  for (const Mesh& mesh : scene.meshes) droppedTriangles += mesh.droppedTriangles;
  traversal = traversalName(choices.traversal);
  triangles = packed.triangles;
  collapsedTriangles = packed.collapsedTriangles;
  nodes = packed.bvh.nodes.size();
  leaves = packed.bvh.leaves;
  depth = packed.bvh.depth;
  stack = packed.bvh.stack;
  sahCost = packed.bvh.sahCost;
  samplesPerPass = choices.tiling.samplesPerPass;
  for (const DeviceArray& array : arraysOf(packed)) {
    const std::uint64_t bytes = array.bytes.size();
    switch (array.binding) {
      case shared::BIND_NODES:
        nodeBytes = bytes;
        break;
      case shared::BIND_TRIANGLES:
        triangleBytes = bytes;
        break;
      case shared::BIND_UVS:
        uvBytes = bytes;
        break;
      case shared::BIND_IMAGES:
        imageBytes = bytes;
        break;
      case shared::BIND_LIGHTS:
      case shared::BIND_JUMPS:
        break;
      default:
        attributeBytes += bytes;
    }
  }
  seconds.build = packed.buildSeconds;
  reasons = choices.reasons;
}

void Stats::add(const FrameWork& work, const RenderTimes& times, const Rendered& rendered) {
  passes = work.passes;
  samples = work.samples;
  bands = times.bands;
  coverage = times.coverage;
  adaptive = times.adaptive;
  droppedSamples = rendered.droppedSamples;
  seconds.upload = work.uploadSeconds;
  seconds.compile += work.compileSeconds;
  seconds.trace = work.traceSeconds;
  seconds.reconstruct = work.gatherSeconds;
  seconds.readBack = times.readBackSeconds;
  for (const ModuleSource source : work.modules) modules.emplace_back(nameOf(source));
  if (work.fallback.empty()) return;
  traversal = traversalName(Traversal::Lane);
  reasons.push_back({"final traversal", traversal, work.fallback, "", 0});
}

void AdaptiveStats::describe(std::span<const SampleMap> maps, const std::vector<Strip>& strips,
                             std::uint32_t bound) {
  const int left = strips[0].pixels.x0, right = strips[0].pixels.x1;
  samples = {right - left, rowsOf(strips), {"samples"}, {}};
  double sum = 0, full = 0;
  min = bound;
  for (std::size_t i = 0; i < strips.size(); ++i)
    for (int y = strips[i].pixels.y0; y < strips[i].pixels.y1; ++y)
      for (int x = left; x < right; ++x) {
        const std::uint32_t count = maps[i].pixel(x, y);
        samples.pixels.push_back(static_cast<float>(count));
        min = std::min(min, count);
        max = std::max(max, count);
        sum += count;
        full += count == bound ? 1 : 0;
      }
  average = sum / static_cast<double>(samples.pixels.size());
  atBound = full / static_cast<double>(samples.pixels.size());
}

std::string textOf(const Reason& reason) {
  std::string text = fmt::format("{:<21}{}: {}", reason.what, reason.choice, reason.why);
  std::string saving;
  if (reason.bytesNotUploaded != 0) saving = fmt::format("{} bytes", reason.bytesNotUploaded);
  if (!reason.saving.empty()) saving += (saving.empty() ? "" : ", ") + reason.saving;
  return text + (saving.empty() ? "\n" : fmt::format("; saves {}\n", saving));
}

nlohmann::json jsonOf(const Reason& reason) {
  return {{"what", reason.what},
          {"decision", reason.choice},
          {"reason", reason.why},
          {"saving", reason.saving},
          {"bytesNotUploaded", reason.bytesNotUploaded}};
}

nlohmann::json Stats::json() const {
  nlohmann::json choices = nlohmann::json::array();
  for (const Reason& reason : reasons) choices.push_back(jsonOf(reason));
  return {{"device", device},
          {"driver", driver},
          {"traversal", traversal},
          {"seconds",
           {{"vulkanStart", seconds.vulkanStart},
            {"load", seconds.load},
            {"build", seconds.build},
            {"upload", seconds.upload},
            {"compile", seconds.compile},
            {"trace", seconds.trace},
            {"reconstruct", seconds.reconstruct},
            {"readBack", seconds.readBack},
            {"write", seconds.write},
            {"total", seconds.total}}},
          {"triangles",
           {{"uploaded", triangles},
            {"droppedZeroArea", droppedTriangles},
            {"droppedCollapsed", collapsedTriangles}}},
          {"bvh",
           {{"nodes", nodes},
            {"leaves", leaves},
            {"depth", depth},
            {"stack", stack},
            {"sahCost", sahCost},
            {"nodeBytes", nodeBytes},
            {"triangleBytes", triangleBytes},
            {"attributeBytes", attributeBytes}}},
          {"textures", {{"imageBytes", imageBytes}, {"uvBytes", uvBytes}}},
          {"samples",
           {{"total", samples},
            {"dropped", droppedSamples},
            {"perPass", samplesPerPass},
            {"passes", passes},
            {"bands", bands},
            {"seen", coverage}}},
          {"adaptive",
           {{"error", adaptive.error},
            {"pilotSamples", adaptive.pilotSamples},
            {"averageSamples", adaptive.average},
            {"minSamples", adaptive.min},
            {"maxSamples", adaptive.max},
            {"shareAtBound", adaptive.atBound}}},
          {"peakBytes", peakBytes},
          {"kernels", modules},
          {"choices", choices}};
}

std::string Stats::text() const {
  const auto ms = [](double s) { return fmt::format("{:.1f} ms", s * 1e3); };
  std::string out;
  out += fmt::format("device       {} ({}), traversal {}\n", device, driver, traversal);
  out += fmt::format("triangles    {} ({} of zero area and {} collapsed in float left out)\n",
                     triangles, droppedTriangles, collapsedTriangles);
  out += fmt::format("bvh          {} nodes, {} leaves, depth {}, stack {}, SAH cost {:.2f}\n",
                     nodes, leaves, depth, stack, sahCost);
  out += fmt::format("bytes        nodes {}, triangles {}, attributes {}", nodeBytes, triangleBytes,
                     attributeBytes);
  if (imageBytes + uvBytes != 0)
    out += fmt::format(", pictures {}, texture coordinates {}", imageBytes, uvBytes);
  out += '\n';
  out += fmt::format("samples      {} in {} passes of {} per pixel, {} bands, {} dropped\n",
                     samples, passes, samplesPerPass, bands, droppedSamples);
  if (coverage < 1.0)
    out += fmt::format(
        "film         {:.1f} % of the pixels see no geometry and are neither traced nor filtered\n",
        100.0 * (1.0 - coverage));
  if (adaptive.error > 0.0)
    out += fmt::format(
        "adaptive     error {}: {:.2f} samples per pixel, {} to {}, {:.2f} % of the pixels at the "
        "bound; {} pilot samples\n",
        adaptive.error, adaptive.average, adaptive.min, adaptive.max, 100.0 * adaptive.atBound,
        adaptive.pilotSamples);
  out += fmt::format(
      "time         Vulkan start {}, load {}, build {}, upload {}, compile {}, trace {}, "
      "reconstruct {}, read back {}, write {}, total {}\n",
      ms(seconds.vulkanStart), ms(seconds.load), ms(seconds.build), ms(seconds.upload),
      ms(seconds.compile), ms(seconds.trace), ms(seconds.reconstruct), ms(seconds.readBack),
      ms(seconds.write), ms(seconds.total));
  out += fmt::format("memory       {:.0f} MiB peak\n", static_cast<double>(peakBytes) / 1048576.0);
  out += fmt::format("kernels      {}\n", joined(modules));
  for (const Reason& reason : reasons) out += textOf(reason);
  return out;
}

}  // namespace laver
