#pragma once
#include <string>

#include "kernels/modules.h"
#include "vulkan/kernel.h"

namespace laver {

/// A kernel and where its SPIR-V came from.
struct CompiledKernel {
  Kernel kernel;
  ModuleSource source;
};

/// The two kernels of a picture.
struct Kernels {
  CompiledKernel trace, gather;
};

/// Composes a kernel's module and has the driver make machine code of it, which lavapipe puts off
/// to the first dispatch: `bindings` hold buffers of the formats that will be read. Throws
/// Error(Scene) for errors in a user's own text.
CompiledKernel compileKernel(const Device& device, const Bindings& bindings,
                             const std::string& text);

/// Compiles both side by side, before there is a scene on the device.
Kernels compileKernels(const Device& device, const TraceKey& trace, const GatherKey& gather,
                       VkFormat attributes);

}  // namespace laver
