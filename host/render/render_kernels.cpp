#include "render/render_kernels.h"

#include <future>

#include "core/beside.h"
#include "kernels/compose.h"
#include "render/device_scene.h"

namespace laver {

std::shared_ptr<const CompiledKernel> compileKernel(const Device& device, const Bindings& bindings,
                                                    const std::string& text) {
  const Module module = moduleOf(text);
  Kernel kernel(device, bindings, module.words, sizeof(shared::Pass));
  const shared::Pass nothing{};
  device.run([&](VkCommandBuffer commands) {
    kernel.dispatch(commands, bindings, std::as_bytes(std::span(&nothing, 1)), {0, 1, 1});
  });
  return std::make_shared<const CompiledKernel>(CompiledKernel{std::move(kernel), module.source});
}

std::shared_ptr<const CompiledKernel> KeptKernels::kernel(const Device& device,
                                                          const Bindings& bindings,
                                                          const std::string& text,
                                                          VkFormat attributes) {
  const std::pair key(text, attributes);
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = kernels_.find(key); found != kernels_.end()) return found->second;
  }
  auto compiled = compileKernel(device, bindings, text);
  const std::lock_guard lock(mutex_);
  return kernels_.emplace(key, std::move(compiled)).first->second;
}

Kernels compileKernels(const Device& device, const TraceKey& trace, const GatherKey& gather,
                       VkFormat attributes, KeptKernels* kept) {
  Packed empty;
  empty.attributeFormat = attributes;
  Tiling smallest{};
  smallest.sampleSlots = smallest.bandPixels = 1;
  const DeviceScene standIn(device, empty, smallest, trace.storageTexels);
  const auto compiled = [&](const std::string& text) {
    return kept != nullptr ? kept->kernel(device, standIn.bindings(), text, attributes)
                           : compileKernel(device, standIn.bindings(), text);
  };
  auto gathering = std::async(kBeside, [&] { return compiled(compose(gather)); });
  auto tracing = compiled(compose(trace));
  return {std::move(tracing), gathering.get()};
}

}  // namespace laver
