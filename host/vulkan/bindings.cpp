#include "vulkan/bindings.h"

namespace laver {

Bindings::Bindings(const Device& device, std::span<const VkDescriptorType> types)
    : device_(&device), types_(types.begin(), types.end()) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  std::vector<VkDescriptorPoolSize> sizes;
  for (std::uint32_t i = 0; i < types_.size(); ++i) {
    bindings.push_back({i, types_[i], 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    sizes.push_back({types_[i], 1});
  }
  VkDescriptorSetLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  layoutInfo.bindingCount = static_cast<std::uint32_t>(bindings.size());
  layoutInfo.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device.get(), &layoutInfo, nullptr, &layout),
        "vkCreateDescriptorSetLayout");
  layout_ = {device.get(), layout, vkDestroyDescriptorSetLayout};

  VkDescriptorPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  poolInfo.maxSets = 1;
  poolInfo.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  poolInfo.pPoolSizes = sizes.data();
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device.get(), &poolInfo, nullptr, &pool), "vkCreateDescriptorPool");
  pool_ = {device.get(), pool, vkDestroyDescriptorPool};

  VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  allocate.descriptorPool = pool;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = &layout;
  check(vkAllocateDescriptorSets(device.get(), &allocate, &set_), "vkAllocateDescriptorSets");
}

void Bindings::bind(std::uint32_t binding, const Buffer& buffer) const {
  const VkDescriptorBufferInfo info{buffer.get(), 0, VK_WHOLE_SIZE};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = types_[binding];
  write.pBufferInfo = &info;
  vkUpdateDescriptorSets(device_->get(), 1, &write, 0, nullptr);
}

void Bindings::bind(std::uint32_t binding, VkBufferView view) const {
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = set_;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = types_[binding];
  write.pTexelBufferView = &view;
  vkUpdateDescriptorSets(device_->get(), 1, &write, 0, nullptr);
}

}  // namespace laver
