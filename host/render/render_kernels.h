#pragma once
#include <map>
#include <memory>
#include <mutex>
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
  std::shared_ptr<const CompiledKernel> trace, gather;
};

/// Keeps kernels for later renders on the same device, which must outlive it.
class KeptKernels {
 public:
  /// Each text is compiled once for buffers of these formats. Threads may share the object.
  std::shared_ptr<const CompiledKernel> kernel(const Device& device, const Bindings& bindings,
                                               const std::string& text, VkFormat attributes);

 private:
  std::mutex mutex_;
  std::map<std::pair<std::string, VkFormat>, std::shared_ptr<const CompiledKernel>> kernels_;
};

/// Compiles a kernel's text and makes the driver generate machine code, which lavapipe defers to
/// the first dispatch; `bindings` must have buffers of the final formats. Throws Error(Scene) for
/// errors in a user's text.
std::shared_ptr<const CompiledKernel> compileKernel(const Device& device, const Bindings& bindings,
                                                    const std::string& text);

/// Compiles both kernels concurrently, before the scene is on the device, or takes them from
/// `kept`, which may be null.
Kernels compileKernels(const Device& device, const TraceKey& trace, const GatherKey& gather,
                       VkFormat attributes, KeptKernels* kept);

}  // namespace laver
