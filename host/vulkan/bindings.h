#pragma once
#include <span>

#include "vulkan/buffer.h"

namespace laver {

/// One descriptor set with its layout and pool.
class Bindings {
 public:
  /// `types[i]` is the descriptor type of binding i.
  Bindings(const Device& device, std::span<const VkDescriptorType> types);

  void bind(std::uint32_t binding, const Buffer& buffer) const;
  void bind(std::uint32_t binding, VkBufferView view) const;

  VkDescriptorSetLayout layout() const { return layout_.get(); }
  VkDescriptorSet set() const { return set_; }

 private:
  const Device* device_;
  std::vector<VkDescriptorType> types_;
  Handle<VkDescriptorSetLayout> layout_;
  Handle<VkDescriptorPool> pool_;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

}  // namespace laver
