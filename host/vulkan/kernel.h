#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "vulkan/bindings.h"

namespace laver {

/// A compute pipeline with its layout.
class Kernel {
 public:
  /// Compiles SPIR-V with the driver; `pushBytes` is the size of the push constants.
  Kernel(const Device& device, const Bindings& bindings, std::span<const std::uint32_t> spirv,
         std::uint32_t pushBytes);

  /// Records a dispatch with the given push constants.
  void dispatch(VkCommandBuffer commands, const Bindings& bindings, std::span<const std::byte> push,
                std::array<std::uint32_t, 3> groups) const;

 private:
  Handle<VkPipelineLayout> layout_;
  Handle<VkPipeline> pipeline_;
};

}  // namespace laver
