#include "render/render_kernels.h"

#include <future>

#include "core/beside.h"
#include "kernels/compose.h"
#include "render/device_scene.h"

namespace laver {

CompiledKernel compileKernel(const Device& device, const Bindings& bindings,
                             const std::string& text) {
  const Module module = moduleOf(text);
  Kernel kernel(device, bindings, module.words, sizeof(shared::Pass));
  const shared::Pass nothing{};
  device.run([&](VkCommandBuffer commands) {
    kernel.dispatch(commands, bindings, std::as_bytes(std::span(&nothing, 1)), {0, 1, 1});
  });
  return {std::move(kernel), module.source};
}

Kernels compileKernels(const Device& device, const TraceKey& trace, const GatherKey& gather,
                       VkFormat attributes) {
  Packed empty;
  empty.attributeFormat = attributes;
  Tiling smallest{};
  smallest.sampleSlots = smallest.bandPixels = 1;
  const DeviceScene standIn(device, empty, smallest);
  auto gathering = std::async(
      kBeside, [&] { return compileKernel(device, standIn.bindings(), compose(gather)); });
  CompiledKernel tracing = compileKernel(device, standIn.bindings(), compose(trace));
  return {std::move(tracing), gathering.get()};
}

}  // namespace laver
