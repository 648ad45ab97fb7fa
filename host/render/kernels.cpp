#include "render/kernels.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>

#include "render/device_scene.h"
#include "render/traversal.h"

namespace laver {

std::string variantOf(const std::string& name, SpecConstants& constants) {
  using namespace shared;
  const auto plain = [&](std::initializer_list<std::uint32_t> read) {
    return std::all_of(read.begin(), read.end(),
                       [&](std::uint32_t id) { return constants[id] == PLAIN[id]; });
  };
  if (name == "gather_packet" && plain({SPEC_NORI_TABLE, SPEC_ADAPTIVE}) &&
      constants[SPEC_FILTER] < FILTERS &&
      constants[SPEC_APRON] == PLAIN_APRON[constants[SPEC_FILTER]])
    return fmt::format("{}_plain_{}", name, constants[SPEC_FILTER]);
  if (name.starts_with("direct_whitted_packet") && constants[SPEC_STACK] <= PLAIN[SPEC_STACK] &&
      plain({SPEC_LIGHTS, SPEC_ADAPTIVE, SPEC_HITS, SPEC_DARK_SIDES})) {
    constants[SPEC_STACK] = PLAIN[SPEC_STACK];
    return fmt::format("{}_plain_{}{}{}", name, constants[SPEC_NORMALS], constants[SPEC_ALBEDOS],
                       constants[SPEC_SAMPLER]);
  }
  return name;
}

Kernel compileKernel(const Device& device, const Bindings& bindings, const std::string& name,
                     SpecConstants constants) {
  const std::string variant = variantOf(name, constants);
  Kernel kernel(device, bindings, variant, constants, sizeof(shared::Pass));
  const shared::Pass nothing{};
  device.run([&](VkCommandBuffer commands) {
    kernel.dispatch(commands, bindings, std::as_bytes(std::span(&nothing, 1)), {0, 1, 1});
  });
  return kernel;
}

Kernels compileKernels(const Device& device, const std::string& traceName,
                       const SpecConstants& constants) {
  SceneData nothing;
  nothing.constants = constants;
  RenderPlan smallest{};
  smallest.sampleSlots = smallest.bandPixels = 1;
  const DeviceScene standIn(device, nothing, smallest);
  auto gather = std::async(std::launch::async, [&] {
    // gather_strip.glsl says what it asks for.
    const bool packet =
        bestTraversal(device.info()) == "packet" && constants[shared::SPEC_APRON] <= 4;
    return compileKernel(device, standIn.bindings(), packet ? "gather_packet" : "gather_lane",
                         constants);
  });
  Kernel trace = compileKernel(device, standIn.bindings(), traceName, constants);
  return {std::move(trace), gather.get()};
}

}  // namespace laver
