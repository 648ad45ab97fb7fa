#include "render/scene_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/attribute_form.h"
#include "render/kernels.h"
#include "render/plan_lines.h"
#include "render/projection.h"
#include "render/renderings.h"
#include "render/sample_map.h"
#include "render/traversal.h"
#include "vulkan/buffer.h"

namespace laver {
namespace {

using Line = ScenePlan::Line;

Line adaptive(const Scene& scene, const RenderOptions& options) {
  if (options.error == 0.0)
    return {"adaptive", "off", "no --error", "counts of cells, and lists of work", 0};
  return {"adaptive", fmt::format("1 to {} samples a pixel", mostOf(scene.sampler)),
          fmt::format("to an error of {:g}, which {} pilots of 1 sample decide", options.error,
                      kPilots),
          "", 0};
}

double seenShare(const SceneData& data, const Rendering& picture, const Crop& core) {
  const auto apron = static_cast<int>(data.constants[shared::SPEC_APRON]);
  return picture.blackMisses ? footprintOf(data).grown(apron).share(core) : 1.0;
}

Line film(const Rendering& picture, double seen) {
  if (!picture.blackMisses) return {"film", "all of it", "what meets nothing is not black", "", 0};
  return {"film", fmt::format("{:.1f} % of it", 100.0 * seen),
          "elsewhere no box of the tree is seen",
          fmt::format("rays and sums of {:.1f} %", 100.0 * (1.0 - seen)), 0};
}

/// The lines and figures of how the render is cut.
void addCut(const Scene& scene, const RenderOptions& options, const Facts& f,
            const DeviceInfo& device, ScenePlan& plan) {
  const std::uint32_t samples = scene.sampler.sampleCount;
  const RenderPlan cut =
      planRender(device.limits, scene, options, f.constant(shared::SPEC_APRON), 0);
  const Crop core = coreOf(scene.camera, options);
  const auto rows = static_cast<std::uint32_t>(core.y1 - core.y0);
  const std::uint32_t bands = (rows + cut.bandRows - 1) / cut.bandRows;
  const std::uint32_t most = options.error == 0.0 ? samples : mostOf(scene.sampler);
  const std::uint32_t passes = (most + cut.samplesAPass - 1) / cut.samplesAPass;
  // Lists of work go by 16 at most.
  const std::uint32_t room =
      std::min({cut.samplesAPass, cut.sideBySide, options.error == 0.0 ? 64U : 16U});
  const std::uint32_t beside = room >= 64 ? 64 : room >= 16 ? 16 : room >= 4 ? 4 : 1;
  const std::uint64_t flight = cut.sampleSlots * 20, film = cut.bandPixels * 32;
  const double density =
      static_cast<double>(f.triangles) / scene.camera.width / scene.camera.height;
  plan.lines.push_back({"side by side", countOf(beside, "sample") + " of a pixel",
                        room < cut.sideBySide ? "no more in a pass"
                                              : fmt::format("{:.2g} triangles to a pixel", density),
                        "", 0});
  plan.lines.push_back(
      {"passes",
       fmt::format("{}{} x {} in {}", options.error == 0.0 ? "" : "up to ", passes,
                   countOf(cut.samplesAPass, "sample"), countOf(bands, "band")),
       fmt::format("{} MiB of samples in flight, {} MiB of film", flight >> 20, film >> 20), "",
       0});
  plan.figures = {{"width", core.x1 - core.x0},
                  {"height", core.y1 - core.y0},
                  {"samples", samples},
                  {"pictures", f.pictures},
                  {"triangles", f.triangles},
                  {"nodes", f.data.bvh.nodes.size()},
                  {"depth", f.data.bvh.depth},
                  {"stackNeeded", f.data.bvh.stack},
                  {"stack", f.constant(shared::SPEC_STACK)},
                  {"indexBytes", f.constant(shared::SPEC_INDEX_BYTES)},
                  {"bytesUploaded", uploadedBytes(f.data)},
                  {"sampleBytes", flight},
                  {"filmBytes", film},
                  {"bands", bands},
                  {"passesABand", passes},
                  {"samplesAPass", cut.samplesAPass},
                  {"samplesSideBySide", beside}};
}

void noteShown(Integrator shown, const Scene& scene, Facts& facts) {
  const bool shaded = shown == Integrator::DirectWhitted;
  facts.shaded = facts.shaded || shaded;
  facts.coloured =
      facts.coloured || shown == Integrator::Albedo || (shaded && !scene.lights.empty());
}

Line integrator(const Scene& scene, std::size_t pictures, const std::string& kernel) {
  if (pictures == 1)
    return {"integrator", integratorName(scene.integrator), "the kernel " + kernel, "all others",
            0};
  return {"integrator", integratorName(scene.integrator),
          fmt::format("{} from one upload, a kernel each", countOf(pictures, "picture")),
          "all others", 0};
}

}  // namespace

std::uint64_t uploadedBytes(const SceneData& data) {
  return data.bvh.nodes.size() * sizeof(shared::Node) +
         data.bvh.triangles.size() * sizeof(shared::Triangle) +
         data.attributes.size() * texelBytes(attributeFormat(data.constants)) +
         data.normals.size() * sizeof(glm::vec4) +
         data.materials.size() * sizeof(shared::Material) +
         data.textures.size() * sizeof(shared::Texture) + data.uvs.size() * sizeof(data.uvs[0]) +
         data.images.size() * sizeof(data.images[0]) + data.lights.size() * sizeof(shared::Light) +
         data.jumps.size() * sizeof(shared::Jump);
}

ScenePlan planScene(const Scene& scene, const RenderOptions& options,
                    const std::string& wantedTraversal, const DeviceInfo& device) {
  ScenePlan plan;
  plan.device = device.name;
  plan.driver = device.driver;
  const std::vector<Rendering> pictures = renderingsOf(scene, options);
  const Chosen chosen = traversalOf(scene, device, wantedTraversal);
  plan.traversal = chosen.traversal;
  SpecConstants constants = constantsOfAll(pictures);
  const std::string kernel = variantOf(pictures.front().kernel + '_' + plan.traversal, constants);
  const SceneData data = packScene(scene, options, constants);
  Facts facts{scene, data, constants[shared::SPEC_STACK]};
  facts.pictures = pictures.size();
  facts.triangles = primitivesOf(scene);
  noteShown(scene.integrator, scene, facts);
  for (const Shown& shown : shownBeside(options.more, options.layers))
    noteShown(shown.integrator, scene, facts);
  for (const Mesh& mesh : scene.meshes) {
    facts.spheres += mesh.sphere ? 1 : 0;
    facts.normals += mesh.normals.size();
    facts.uvs += mesh.uvs.size();
  }
  plan.lines = {integrator(scene, pictures.size(), kernel),
                {"traversal", chosen.traversal, chosen.why, "", 0}};
  for (Line& line : sceneLines(facts)) plan.lines.push_back(std::move(line));
  const double seen = seenShare(data, pictures.front(), coreOf(scene.camera, options));
  plan.lines.push_back(film(pictures.front(), seen));
  plan.lines.push_back(adaptive(scene, options));
  addCut(scene, options, facts, device, plan);
  plan.figures["seen"] = seen;
  return plan;
}

std::string ScenePlan::text() const {
  std::string out = fmt::format("{:<21}{} ({})\n", "device", device, driver);
  for (const Line& line : lines) {
    out += fmt::format("{:<21}{}: {}", line.what, line.decision, line.reason);
    std::string saving;
    if (line.bytesNotUploaded != 0) saving = fmt::format("{} bytes", line.bytesNotUploaded);
    if (!line.saving.empty()) saving += (saving.empty() ? "" : ", ") + line.saving;
    out += saving.empty() ? "\n" : fmt::format("; saves {}\n", saving);
  }
  return out + fmt::format("{:<21}{} bytes of scene\n", "uploads",
                           figures["bytesUploaded"].get<std::uint64_t>());
}

nlohmann::json ScenePlan::json() const {
  nlohmann::json all = nlohmann::json::array();
  for (const Line& line : lines)
    all.push_back({{"what", line.what},
                   {"decision", line.decision},
                   {"reason", line.reason},
                   {"saving", line.saving},
                   {"bytesNotUploaded", line.bytesNotUploaded}});
  return {{"device", device},
          {"driver", driver},
          {"traversal", traversal},
          {"figures", figures},
          {"lines", all}};
}

}  // namespace laver
