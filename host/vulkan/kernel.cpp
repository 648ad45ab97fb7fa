#include "vulkan/kernel.h"

namespace laver {

Kernel::Kernel(const Device& device, const Bindings& bindings, std::span<const std::uint32_t> spirv,
               std::uint32_t pushBytes) {
  VkShaderModuleCreateInfo moduleInfo{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  moduleInfo.codeSize = spirv.size_bytes();
  moduleInfo.pCode = spirv.data();
  VkShaderModule moduleHandle = VK_NULL_HANDLE;
  check(vkCreateShaderModule(device.get(), &moduleInfo, nullptr, &moduleHandle),
        "vkCreateShaderModule");
  const Handle<VkShaderModule> shader(device.get(), moduleHandle, vkDestroyShaderModule);

  const VkDescriptorSetLayout setLayout = bindings.layout();
  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, pushBytes};
  VkPipelineLayoutCreateInfo layoutInfo{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  layoutInfo.setLayoutCount = 1;
  layoutInfo.pSetLayouts = &setLayout;
  layoutInfo.pushConstantRangeCount = 1;
  layoutInfo.pPushConstantRanges = &range;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  check(vkCreatePipelineLayout(device.get(), &layoutInfo, nullptr, &layout),
        "vkCreatePipelineLayout");
  layout_ = {device.get(), layout, vkDestroyPipelineLayout};

  VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = shader.get();
  info.stage.pName = "main";
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  check(
      vkCreateComputePipelines(device.get(), device.pipelineCache(), 1, &info, nullptr, &pipeline),
      "vkCreateComputePipelines");
  pipeline_ = {device.get(), pipeline, vkDestroyPipeline};
}

void Kernel::dispatch(VkCommandBuffer commands, const Bindings& bindings,
                      std::span<const std::byte> push, std::array<std::uint32_t, 3> groups) const {
  const VkDescriptorSet set = bindings.set();
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_.get());
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_.get(), 0, 1, &set, 0,
                          nullptr);
  vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_COMPUTE_BIT, 0,
                     static_cast<std::uint32_t>(push.size()), push.data());
  vkCmdDispatch(commands, groups[0], groups[1], groups[2]);
}

}  // namespace laver
