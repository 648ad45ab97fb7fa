#include "render/kernels.h"

#include <algorithm>
#include <future>
#include <map>
#include <vector>

#include "render/device_scene.h"
#include "render/renderer.h"

namespace laver {
namespace {

/// The kernel, or where PLAIN has all constants that it reads, the variant with these built in.
std::string variantOf(const std::string& name, const SpecConstants& constants) {
  using namespace shared;
  static const std::map<std::string, std::vector<std::uint32_t>> kRead = {
      {"direct_whitted_packet",
       {SPEC_STACK, SPEC_NORMALS, SPEC_ALBEDOS, SPEC_LIGHTS, SPEC_SAMPLER, SPEC_ADAPTIVE}},
      {"gather_packet", {SPEC_FILTER, SPEC_APRON, SPEC_NORI_TABLE, SPEC_ADAPTIVE}}};
  const auto read = kRead.find(name);
  const bool plain = read != kRead.end() &&
                     std::all_of(read->second.begin(), read->second.end(),
                                 [&](std::uint32_t id) { return constants[id] == PLAIN[id]; });
  return plain ? name + "_plain" : name;
}

}  // namespace

Kernel compileKernel(const Device& device, const Bindings& bindings, const std::string& name,
                     const SpecConstants& constants) {
  Kernel kernel(device, bindings, variantOf(name, constants), constants, sizeof(shared::Pass));
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
  smallest.sampleSlots = smallest.bandPixels = 3;  // no power of two, as DeviceScene has it
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
