#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "vulkan/bindings.h"

namespace laver {

/// A compute pipeline with its layout.
class Kernel {
 public:
  /// Compiles shaders/<name>.comp with 32-bit specialisation constants 0, 1, 2 ... and push
  /// constants of `pushBytes`.
  Kernel(const Device& device, const Bindings& bindings, const std::string& name,
         std::span<const std::uint32_t> constants, std::uint32_t pushBytes);
  /// The same of SPIR-V from elsewhere.
  Kernel(const Device& device, const Bindings& bindings, std::span<const std::uint32_t> spirv,
         std::span<const std::uint32_t> constants, std::uint32_t pushBytes);

  /// Records a dispatch with the given push constants.
  void dispatch(VkCommandBuffer commands, const Bindings& bindings, std::span<const std::byte> push,
                std::array<std::uint32_t, 3> groups) const;

 private:
  Handle<VkPipelineLayout> layout_;
  Handle<VkPipeline> pipeline_;
};

/// Makes what dispatches have written visible to those that follow.
void computeBarrier(VkCommandBuffer commands);

}  // namespace laver
