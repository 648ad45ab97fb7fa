#include "render/kernels.h"

#include <future>

#include "render/device_scene.h"
#include "render/traversal.h"

namespace laver {

Kernel compileKernel(const Device& device, const Bindings& bindings, const std::string& name,
                     const SpecConstants& constants) {
  Kernel kernel(device, bindings, name, constants, sizeof(shared::Pass));
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
