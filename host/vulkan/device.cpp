#include "vulkan/device.h"

#include <fmt/format.h>

namespace laver {
namespace {

void memoryBarrier(VkCommandBuffer commands, VkPipelineStageFlags stage, VkAccessFlags access) {
  VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = access;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, stage, 0, 1, &barrier, 0,
                       nullptr, 0, nullptr);
}

}  // namespace

VkPhysicalDevice choosePhysicalDevice(const Instance& instance, const std::string& wanted) {
  const auto devices = instance.devices();
  std::vector<DeviceInfo> infos;
  infos.reserve(devices.size());
  for (const VkPhysicalDevice device : devices) infos.push_back(deviceInfo(device));
  return devices[chooseDevice(infos, wanted)];
}

Device::Device(VkPhysicalDevice physical) : info_(deviceInfo(physical)) {
  if (const std::string why = rejection(info_); !why.empty())
    throw Error(ExitCode::Device, fmt::format("{} cannot be used: {}", info_.name, why));
  const auto family = static_cast<std::uint32_t>(info_.computeFamily);
  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = family;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkPhysicalDeviceFeatures features{};
  features.shaderInt64 = info_.longs ? VK_TRUE : VK_FALSE;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.pEnabledFeatures = &features;
  check(vkCreateDevice(physical, &info, nullptr, &device_), "vkCreateDevice");
  volkLoadDevice(device_);
  vkGetDeviceQueue(device_, family, 0, &queue_);

  VkCommandPoolCreateInfo poolInfo{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  poolInfo.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  poolInfo.queueFamilyIndex = family;
  VkCommandPool pool = VK_NULL_HANDLE;
  check(vkCreateCommandPool(device_, &poolInfo, nullptr, &pool), "vkCreateCommandPool");
  pool_ = {device_, pool, vkDestroyCommandPool};
  VkCommandBufferAllocateInfo commands{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  commands.commandPool = pool;
  commands.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  commands.commandBufferCount = 1;
  check(vkAllocateCommandBuffers(device_, &commands, &commands_), "vkAllocateCommandBuffers");
  VkFenceCreateInfo fenceInfo{VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  VkFence fence = VK_NULL_HANDLE;
  check(vkCreateFence(device_, &fenceInfo, nullptr, &fence), "vkCreateFence");
  fence_ = {device_, fence, vkDestroyFence};
  cache_.emplace(physical, device_);
}

Device::~Device() {
  vkDeviceWaitIdle(device_);
  cache_.reset();
  fence_ = {};
  pool_ = {};
  vkDestroyDevice(device_, nullptr);
}

int Device::memoryType(std::uint32_t bits, VkMemoryPropertyFlags flags) const {
  for (std::uint32_t i = 0; i < info_.memory.memoryTypeCount; ++i)
    if ((bits >> i & 1U) != 0 && (info_.memory.memoryTypes[i].propertyFlags & flags) == flags)
      return static_cast<int>(i);
  return -1;
}

VkMemoryPropertyFlags Device::memoryFlags(std::uint32_t type) const {
  return info_.memory.memoryTypes[type].propertyFlags;
}

void Device::run(const std::function<void(VkCommandBuffer)>& record) const {
  const std::lock_guard lock(running_);
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(commands_, &begin), "vkBeginCommandBuffer");
  // Writes of earlier submissions become visible to this one, and this one's to the host.
  memoryBarrier(commands_, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT);
  record(commands_);
  memoryBarrier(commands_, VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
  check(vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
  VkSubmitInfo submit{VK_STRUCTURE_TYPE_SUBMIT_INFO};
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands_;
  const VkFence fence = fence_.get();
  check(vkQueueSubmit(queue_, 1, &submit, fence), "vkQueueSubmit");
  check(vkWaitForFences(device_, 1, &fence, VK_TRUE, UINT64_MAX), "vkWaitForFences");
  check(vkResetFences(device_, 1, &fence), "vkResetFences");
}

void Device::requireLimit(const char* limit, std::uint64_t wanted, std::uint64_t available) {
  if (wanted > available)
    throw Error(ExitCode::Device,
                fmt::format("the device's {} is {}, the scene needs {}", limit, available, wanted));
}

}  // namespace laver
