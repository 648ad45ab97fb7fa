#include "render/scene_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/attribute_form.h"
#include "render/traversal.h"
#include "vulkan/buffer.h"

namespace laver {
namespace {

using Line = ScenePlan::Line;

std::string count(std::uint64_t n, const char* what) {
  return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
}

/// What the lines are made of.
struct Facts {
  const Scene& scene;
  const SceneData& data;
  std::uint64_t triangles = 0, normals = 0, uvs = 0;
  bool packet = false;

  std::uint32_t constant(std::uint32_t c) const { return data.constants[c]; }
  bool shaded() const { return scene.integrator == Integrator::DirectWhitted; }
  bool traced() const { return constant(shared::SPEC_HITS) != 0; }
};

/// Bytes of the attributes of all triangles in a form, without the tables they point into.
std::uint64_t indexBytesOf(const Facts& f, SpecConstants constants) {
  const bool any = constants[shared::SPEC_NORMALS] != 0 || constants[shared::SPEC_ALBEDOS] != 0;
  return any ? f.data.triangles * texelBytes(attributeFormat(constants)) : 0;
}

Line rays(const Facts& f) {
  if (f.traced()) return {"camera rays", "traced", "what they hit shows", "", 0};
  return {"camera rays", "none traced", "a scene without lights is black",
          "the tree is not built, no ray is traced", f.triangles * sizeof(shared::Triangle)};
}

Line tree(const Facts& f) {
  const Bvh& bvh = f.data.bvh;
  if (!f.traced()) return {"tree", "not built", "no ray is traced", "", 0};
  return {
      "tree",
      fmt::format("{} of up to 8 children, depth {}", count(bvh.nodes.size(), "node"), bvh.depth),
      "built for this plan: nothing else tells its depth", "", 0};
}

Line stack(const Facts& f, std::uint32_t guess) {
  const std::uint32_t entries = f.constant(shared::SPEC_STACK), needed = f.data.bvh.stack;
  const std::uint32_t generic =
      generalise(f.data.constants, 1U << shared::SPEC_STACK)[shared::SPEC_STACK];
  Line line{"stack", fmt::format("{} entries", entries), "", "", 0};
  line.reason =
      entries > guess     ? fmt::format("the tree needs {}: the kernel is compiled anew", needed)
      : entries < generic ? fmt::format("{} never fill more; the tree needs {}",
                                        count(f.triangles, "triangle"), needed)
                          : fmt::format(
                                "the tree needs {}; set before it is there, so that kernels "
                                "compile beside it",
                                needed);
  if (entries < generic) line.saving = fmt::format("{} entries", generic - entries);
  return line;
}

Line normals(const Facts& f) {
  if (f.constant(shared::SPEC_NORMALS) != 0)
    return {"vertex normals", count(f.normals, "normal"),
            f.shaded() ? "shading reads them" : "the integrator shows them", "", 0};
  SpecConstants with = f.data.constants;
  with[shared::SPEC_NORMALS] = 1;
  with[shared::SPEC_INDEX_BYTES] = indexBytes(f.scene, true);
  const std::uint64_t bytes = f.traced()
                                  ? (f.normals + 1) * sizeof(glm::vec4) + indexBytesOf(f, with) -
                                        indexBytesOf(f, f.data.constants)
                                  : 0;
  return {"vertex normals", "left out",
          !f.traced() ? "no ray is traced"
          : f.normals == 0
              ? "no mesh has any"
              : fmt::format("{} does not show them", integratorName(f.scene.integrator)),
          "4 loads a hit, interpolation", bytes};
}

Line materials(const Facts& f) {
  const std::size_t meshes = f.scene.meshes.size();
  if (f.constant(shared::SPEC_ALBEDOS) != 0)
    return {"materials", count(meshes, "albedo"), "the meshes differ", "", 0};
  SpecConstants with = f.data.constants;
  with[shared::SPEC_ALBEDOS] = 1;
  const std::uint64_t bytes = f.traced()
                                  ? meshes * sizeof(shared::Material) + indexBytesOf(f, with) -
                                        indexBytesOf(f, f.data.constants)
                                  : 0;
  const bool one = f.shaded() && f.traced();
  return {"materials", one ? "one albedo, a parameter" : "left out",
          one           ? "all meshes agree"
          : !f.traced() ? "no ray is traced"
                        : fmt::format("{} does not show them", integratorName(f.scene.integrator)),
          "1 load a hit and light", bytes};
}

Line uvs(const Facts& f) {
  return {"texture coordinates", "left out", "no texture reads them", "",
          f.uvs * 2 * sizeof(float)};
}

Line indices(const Facts& f) {
  const bool any = f.constant(shared::SPEC_NORMALS) != 0 || f.constant(shared::SPEC_ALBEDOS) != 0;
  if (!any) return {"indices", "left out", "there is nothing to point into", "", 0};
  const std::uint32_t bytes = f.constant(shared::SPEC_INDEX_BYTES);
  const std::uint64_t wide =
      indexBytesOf(f, generalise(f.data.constants, 1U << shared::SPEC_INDEX_BYTES));
  return {"indices", fmt::format("{} bits", bytes * 8),
          fmt::format("the largest is {}",
                      f.constant(shared::SPEC_NORMALS) != 0
                          ? std::max<std::uint64_t>(f.normals, f.scene.meshes.size())
                          : f.scene.meshes.size() - 1),
          "", wide - indexBytesOf(f, f.data.constants)};
}

Line lights(const Facts& f) {
  const std::size_t lights = f.scene.lights.size();
  switch (f.constant(shared::SPEC_LIGHTS)) {
    case shared::LIGHTS_NONE:
      return {"lights", "left out",
              lights == 0 ? "the scene has none"
                          : fmt::format("{} shows none", integratorName(f.scene.integrator)),
              "no shadow ray is traced", lights * sizeof(shared::Light)};
    case shared::LIGHTS_FEW:
      return {"lights", count(lights, "light") + " in one dispatch",
              fmt::format("{} or fewer", shared::LIGHTS_A_DISPATCH),
              "reading back what earlier dispatches summed", 0};
    default:
      return {"lights",
              fmt::format("{} in {} dispatches", count(lights, "light"),
                          (lights + shared::LIGHTS_A_DISPATCH - 1) / shared::LIGHTS_A_DISPATCH),
              fmt::format("more than {}", shared::LIGHTS_A_DISPATCH), "", 0};
  }
}

Line shadowRays(const Facts& f) {
  if (f.constant(shared::SPEC_LIGHTS) == shared::LIGHTS_NONE)
    return {"shadow rays", "none", "no light is shown", "", 0};
  return {"shadow rays", "where n.l > 0 and n.v > 0", "elsewhere no light arrives",
          "those of surfaces that face away", 0};
}

Line sampler(const Facts& f) {
  const std::uint32_t levels = f.constant(shared::SPEC_JUMP_LEVELS);
  return {"sampler tables", fmt::format("{} of 3", levels),
          count(f.scene.sampler.sampleCount, "sample") + " a pixel",
          levels == 3 ? "" : count(3 - levels, "jump") + " a sample", 0};
}

Line filter(const Facts& f) {
  const char* names[] = {"gaussian, an exponential a weight", "Mitchell", "tent", "box",
                         "gaussian, weights by products"};
  const std::uint32_t apron = f.constant(shared::SPEC_APRON);
  return {
      "filter",
      fmt::format("{}, {} x {} pixels",
                  f.constant(shared::SPEC_NORI_TABLE) != 0 ? "Nori's table"
                                                           : names[f.constant(shared::SPEC_FILTER)],
                  2 * apron + 1, 2 * apron + 1),
      fmt::format("its radius is {:g}", f.scene.filter.radius),
      "the other filters, and pixels out of reach", 0};
}

}  // namespace

std::uint64_t uploadedBytes(const SceneData& data) {
  return data.bvh.nodes.size() * sizeof(shared::Node) +
         data.bvh.triangles.size() * sizeof(shared::Triangle) +
         data.attributes.size() * texelBytes(attributeFormat(data.constants)) +
         data.normals.size() * sizeof(glm::vec4) +
         data.materials.size() * sizeof(shared::Material) +
         data.lights.size() * sizeof(shared::Light) + data.jumps.size() * sizeof(shared::Jump);
}

ScenePlan planScene(const Scene& scene, const RenderOptions& options,
                    const std::string& wantedTraversal, const DeviceInfo& device) {
  ScenePlan plan;
  plan.device = device.name;
  plan.driver = device.driver;
  plan.traversal = traversalFor(device, wantedTraversal);
  const SpecConstants constants = specialise(scene, options);
  const SceneData data = packScene(scene, options, constants);
  Facts f{scene, data};
  for (const Mesh& mesh : scene.meshes) {
    f.triangles += mesh.triangles.size();
    f.normals += mesh.normals.size();
    f.uvs += mesh.uvs.size();
  }
  std::string why = "asked for";
  if (wantedTraversal.empty()) {
    const bool dense = plan.traversal == "packet" && tooDenseForPackets(f.triangles, scene);
    why = dense                        ? "more than 5 triangles to a ray"
          : plan.traversal == "packet" ? "subgroups of 8 lanes that shuffle, up to 5 triangles to "
                                         "a ray"
                                       : "no subgroups of 8 lanes that shuffle";
    if (dense) plan.traversal = "lane";
  }

  const Camera& camera = scene.camera;
  const Crop core = options.crop.value_or(Crop{0, 0, camera.width, camera.height});
  const std::uint32_t samples = scene.sampler.sampleCount;
  const RenderPlan cut = planRender(device.limits, core, camera.width, camera.height,
                                    data.constants[shared::SPEC_APRON], samples, 0);
  const auto rows = static_cast<std::uint32_t>(core.y1 - core.y0);
  const std::uint32_t bands = (rows + cut.bandRows - 1) / cut.bandRows;
  const std::uint32_t passes = (samples + cut.samplesAPass - 1) / cut.samplesAPass;
  const std::uint32_t beside = cut.samplesAPass >= 16 ? 16 : cut.samplesAPass >= 4 ? 4 : 1;
  const std::uint64_t flight = cut.sampleSlots * 20, film = cut.bandPixels * 32;

  plan.lines = {
      {"integrator", integratorName(scene.integrator), "a kernel of its own", "all others", 0},
      {"traversal", plan.traversal, why, "", 0},
      rays(f),
      tree(f),
      stack(f, constants[shared::SPEC_STACK]),
      normals(f),
      materials(f),
      uvs(f),
      indices(f),
      lights(f),
      shadowRays(f),
      sampler(f),
      filter(f),
      {"passes",
       fmt::format("{} x {} in {}, {} side by side", passes, count(cut.samplesAPass, "sample"),
                   count(bands, "band"), beside),
       fmt::format("{} MiB of samples in flight, {} MiB of film", flight >> 20, film >> 20), "",
       0}};
  plan.figures = {{"width", core.x1 - core.x0},
                  {"height", core.y1 - core.y0},
                  {"samples", samples},
                  {"triangles", f.triangles},
                  {"nodes", data.bvh.nodes.size()},
                  {"depth", data.bvh.depth},
                  {"stackNeeded", data.bvh.stack},
                  {"stack", data.constants[shared::SPEC_STACK]},
                  {"indexBytes", data.constants[shared::SPEC_INDEX_BYTES]},
                  {"bytesUploaded", uploadedBytes(data)},
                  {"sampleBytes", flight},
                  {"filmBytes", film},
                  {"bands", bands},
                  {"passesABand", passes},
                  {"samplesAPass", cut.samplesAPass},
                  {"samplesSideBySide", beside}};
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
