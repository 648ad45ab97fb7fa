#pragma once
#include <string>

#include "kernels/modules.h"
#include "vulkan/kernel.h"

namespace laver {

/// A kernel and the source of its SPIR-V.
struct CompiledKernel {
  Kernel kernel;
  ModuleSource source;
};

/// The kernels of a picture.
struct Kernels {
  CompiledKernel trace, gather;
};

/// Compiles a kernel's text and makes the driver generate machine code, which lavapipe defers to
/// the first dispatch; `bindings` must have buffers of the final formats. Throws Error(Scene) for
/// errors in a user's text.
CompiledKernel compileKernel(const Device& device, const Bindings& bindings,
                             const std::string& text);

/// Compiles both kernels concurrently, before the scene is on the device.
Kernels compileKernels(const Device& device, const TraceKey& trace, const GatherKey& gather,
                       VkFormat attributes);

}  // namespace laver
