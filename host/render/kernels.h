#pragma once
#include <string>

#include "render/specialise.h"
#include "vulkan/kernel.h"

namespace laver {

/// The kernel, or its variant with these constants built in where there is one, which takes less
/// time to compile (PLAIN in layout.h). A stack in it may be larger: then `constants` tell so.
std::string variantOf(const std::string& name, SpecConstants& constants);

/// Compiles shaders/<name>.comp and has the driver make machine code of it, which lavapipe puts off
/// to the first dispatch: `bindings` hold buffers of the formats that will be read.
Kernel compileKernel(const Device& device, const Bindings& bindings, const std::string& name,
                     SpecConstants constants);

/// The two kernels of a picture.
struct Kernels {
  Kernel trace, gather;
};

/// Compiles them side by side, before there is a scene on the device.
Kernels compileKernels(const Device& device, const std::string& traceName,
                       const SpecConstants& constants);

}  // namespace laver
