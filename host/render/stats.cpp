#include "render/stats.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/attribute_form.h"
#include "vulkan/buffer.h"

namespace laver {

void Stats::describe(const SceneData& data) {
  triangles = data.triangles;
  collapsedTriangles = data.collapsedTriangles;
  nodes = data.bvh.nodes.size();
  leaves = data.bvh.leaves;
  depth = data.bvh.depth;
  stack = data.bvh.stack;
  sahCost = data.bvh.sahCost;
  nodeBytes = nodes * sizeof(shared::Node);
  triangleBytes = data.bvh.triangles.size() * sizeof(shared::Triangle);
  attributeBytes = data.attributes.size() * texelBytes(attributeFormat(data.constants)) +
                   data.normals.size() * sizeof(glm::vec4) +
                   data.materials.size() * sizeof(shared::Material) +
                   data.textures.size() * sizeof(shared::Texture);
  imageBytes = data.images.size() * sizeof(data.images[0]);
  uvBytes = data.uvs.size() * sizeof(data.uvs[0]);
  seconds.build = data.buildSeconds;
  const SpecConstants& c = data.constants;
  if (c[shared::SPEC_HITS] == 0) leftOut.emplace_back("camera rays and the tree: no light");
  if (c[shared::SPEC_NORMALS] == 0) leftOut.emplace_back("vertex normals: none needed");
  if (c[shared::SPEC_ALBEDOS] == 0) leftOut.emplace_back("materials: one albedo or none needed");
  if (c[shared::SPEC_LIGHTS] == 0) leftOut.emplace_back("shadow rays: no light needed");
  if (c[shared::SPEC_TEXTURES] == 0) leftOut.emplace_back("textures: none needed");
  if (c[shared::SPEC_BACKGROUND] == shared::BACKGROUND_BLACK)
    leftOut.emplace_back("background: none needed");
  if (c[shared::SPEC_SPHERES] == 0) leftOut.emplace_back("spheres: none needed");
  if (c[shared::SPEC_JUMP_LEVELS] < 3)
    leftOut.push_back(fmt::format("sampler tables: {} of 3 needed", c[shared::SPEC_JUMP_LEVELS]));
}

void AdaptiveStats::describe(const SampleMap& map, Crop core, std::uint32_t bound) {
  samples = {core.x1 - core.x0, core.y1 - core.y0, {"samples"}, {}};
  double sum = 0, full = 0;
  least = bound;
  for (int y = core.y0; y < core.y1; ++y)
    for (int x = core.x0; x < core.x1; ++x) {
      const std::uint32_t count = map.pixel(x, y);
      samples.pixels.push_back(static_cast<float>(count));
      least = std::min(least, count);
      most = std::max(most, count);
      sum += count;
      full += count == bound ? 1 : 0;
    }
  average = sum / static_cast<double>(samples.pixels.size());
  atBound = full / static_cast<double>(samples.pixels.size());
}

nlohmann::json Stats::json() const {
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
            {"perPass", samplesAPass},
            {"passes", passes},
            {"bands", bands},
            {"seen", seen}}},
          {"adaptive",
           {{"error", adaptive.error},
            {"pilotSamples", adaptive.pilotSamples},
            {"averageSamples", adaptive.average},
            {"leastSamples", adaptive.least},
            {"mostSamples", adaptive.most},
            {"shareAtBound", adaptive.atBound}}},
          {"peakBytes", peakBytes},
          {"leftOut", leftOut}};
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
  out += fmt::format("samples      {} in {} passes of {} a pixel, {} bands, {} dropped\n", samples,
                     passes, samplesAPass, bands, droppedSamples);
  if (seen < 1.0)
    out +=
        fmt::format("film         {:.1f} % of it sees nothing, and is neither traced nor summed\n",
                    100.0 * (1.0 - seen));
  if (adaptive.error > 0.0)
    out += fmt::format(
        "adaptive     error {}: {:.2f} samples a pixel, {} to {}, {:.2f} % of the pixels at the "
        "bound; {} pilot samples\n",
        adaptive.error, adaptive.average, adaptive.least, adaptive.most, 100.0 * adaptive.atBound,
        adaptive.pilotSamples);
  out += fmt::format(
      "time         Vulkan start {}, load {}, build {}, upload {}, compile {}, trace {}, "
      "reconstruct {}, read back {}, write {}, total {}\n",
      ms(seconds.vulkanStart), ms(seconds.load), ms(seconds.build), ms(seconds.upload),
      ms(seconds.compile), ms(seconds.trace), ms(seconds.reconstruct), ms(seconds.readBack),
      ms(seconds.write), ms(seconds.total));
  out += fmt::format("memory       {:.0f} MiB at the peak\n",
                     static_cast<double>(peakBytes) / 1048576.0);
  for (const auto& line : leftOut) out += fmt::format("left out     {}\n", line);
  return out;
}

}  // namespace laver
