#include "vulkan/buffer.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <cstring>
#include <memory>

namespace laver {
namespace {

VkBufferUsageFlags usage(Buffer::Use use) {
  constexpr VkBufferUsageFlags transfer =
      VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  switch (use) {
    case Buffer::Use::Uniform:
      return transfer | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
    case Buffer::Use::Texels:
      return transfer | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
    case Buffer::Use::Storage:
      return transfer | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
    case Buffer::Use::StorageTexels:
      break;
  }
  return transfer | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT;
}

Handle<VkBuffer> createBuffer(const Device& device, VkBufferUsageFlags flags, VkDeviceSize bytes) {
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = bytes;
  info.usage = flags;
  VkBuffer buffer = VK_NULL_HANDLE;
  check(vkCreateBuffer(device.get(), &info, nullptr, &buffer), "vkCreateBuffer");
  return {device.get(), buffer, vkDestroyBuffer};
}

constexpr VkMemoryPropertyFlags kHost =
    VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
// Larger staging transfers are split into pieces of this size.
constexpr VkDeviceSize kStagingBytes = VkDeviceSize{64} << 20;

/// A CPU device gets its memory page by page on first touch, at 2.5 us per 4 KiB page; huge pages
/// avoid most of that. Only a hint: a refusal changes nothing.
void requestHugePages(void* memory, std::size_t bytes) {
  constexpr std::size_t kPage = std::size_t{2} << 20;
  if (std::align(kPage, kPage, memory, bytes) != nullptr)
    ::madvise(memory, bytes / kPage * kPage, MADV_HUGEPAGE);
}

}  // namespace

Buffer::Buffer(const Device& device, const char* what, Use use, VkDeviceSize bytes)
    : device_(&device), bytes_(bytes) {
  const VkPhysicalDeviceLimits& limits = device.limits();
  const auto require = [&](const char* limit, std::uint64_t available) {
    if (bytes > available)
      throw Error(ExitCode::Device, fmt::format("{}: {} bytes, the device's {} is {}", what, bytes,
                                                limit, available));
  };
  require("maxMemoryAllocationSize", device.maxAllocation());
  if (use == Use::Storage || use == Use::StorageTexels)
    require("maxStorageBufferRange", limits.maxStorageBufferRange);
  if (use == Use::Uniform) require("maxUniformBufferRange", limits.maxUniformBufferRange);
  buffer_ = createBuffer(device, usage(use), bytes);
  allocate(device, what, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | kHost,
           VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
}

Buffer::Buffer(const Device& device, Staging, VkDeviceSize bytes)
    : device_(&device),
      bytes_(bytes),
      buffer_(createBuffer(
          device, VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT, bytes)) {
  allocate(device, "staging", kHost | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, kHost);
}

void Buffer::allocate(const Device& device, const char* what, VkMemoryPropertyFlags preferred,
                      VkMemoryPropertyFlags required) {
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(device.get(), buffer_.get(), &needs);
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = needs.size;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  int type = -1;
  // Host-visible device memory may be a small window that is full while plain device memory is not.
  for (const VkMemoryPropertyFlags flags : {preferred, required, VkMemoryPropertyFlags{0}}) {
    type = device.memoryType(needs.memoryTypeBits, flags);
    if (type < 0) continue;
    info.memoryTypeIndex = static_cast<std::uint32_t>(type);
    result = vkAllocateMemory(device.get(), &info, nullptr, &memory);
    if (result == VK_SUCCESS) break;
  }
  if (result != VK_SUCCESS)
    throw Error(ExitCode::Device, fmt::format("{}: no memory for {} bytes (vkAllocateMemory: {})",
                                              what, needs.size, resultName(result)));
  memory_ = {device.get(), memory, vkFreeMemory};
  check(vkBindBufferMemory(device.get(), buffer_.get(), memory, 0), "vkBindBufferMemory");
  if ((device.memoryFlags(info.memoryTypeIndex) & kHost) == kHost) {
    void* pointer = nullptr;
    check(vkMapMemory(device.get(), memory, 0, VK_WHOLE_SIZE, 0, &pointer), "vkMapMemory");
    mapped_ = static_cast<std::byte*>(pointer);
    if (device.info().type == VK_PHYSICAL_DEVICE_TYPE_CPU) requestHugePages(mapped_, needs.size);
    cached_ = (device.memoryFlags(info.memoryTypeIndex) & VK_MEMORY_PROPERTY_HOST_CACHED_BIT) != 0;
  }
}

void Buffer::upload(std::span<const std::byte> data) const {
  if (mapped_ != nullptr) {
    std::memcpy(mapped_, data.data(), data.size());
    return;
  }
  const Buffer staging(*device_, Staging{}, std::min<VkDeviceSize>(data.size(), kStagingBytes));
  for (VkDeviceSize at = 0; at < data.size(); at += kStagingBytes) {
    const VkDeviceSize size = std::min<VkDeviceSize>(kStagingBytes, data.size() - at);
    std::memcpy(staging.mapped_, data.data() + at, size);
    device_->run([&](VkCommandBuffer commands) {
      const VkBufferCopy region{0, at, size};
      vkCmdCopyBuffer(commands, staging.get(), get(), 1, &region);
    });
  }
}

void Buffer::download(std::span<std::byte> data) const {
  if (mapped_ != nullptr) {
    std::memcpy(data.data(), mapped_, data.size());
    return;
  }
  const Buffer staging(*device_, Staging{}, std::min<VkDeviceSize>(data.size(), kStagingBytes));
  for (VkDeviceSize at = 0; at < data.size(); at += kStagingBytes) {
    const VkDeviceSize size = std::min<VkDeviceSize>(kStagingBytes, data.size() - at);
    device_->run([&](VkCommandBuffer commands) {
      const VkBufferCopy region{at, 0, size};
      vkCmdCopyBuffer(commands, get(), staging.get(), 1, &region);
    });
    std::memcpy(data.data() + at, staging.mapped_, size);
  }
}

std::span<const std::byte> Buffer::contents(VkDeviceSize bytes,
                                            std::vector<std::byte>& copy) const {
  if (mapped_ != nullptr && cached_) return {mapped_, bytes};
  copy.resize(bytes);
  download(copy);
  return copy;
}

void Buffer::fill(std::uint32_t word, VkDeviceSize from) const {
  device_->run([&](VkCommandBuffer commands) {
    vkCmdFillBuffer(commands, get(), from, VK_WHOLE_SIZE, word);
  });
}

VkDeviceSize texelBytes(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R8_UINT:
      return 1;
    case VK_FORMAT_R16_UINT:
      return 2;
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R32_SFLOAT:
    case VK_FORMAT_R8G8B8A8_UINT:
      return 4;
    case VK_FORMAT_R16G16B16A16_UINT:
    case VK_FORMAT_R32G32_UINT:
      return 8;
    default:
      return 16;
  }
}

VkDeviceSize wordBytes(VkFormat format) {
  switch (format) {
    case VK_FORMAT_R8_UINT:
    case VK_FORMAT_R8G8B8A8_UINT:
      return 1;
    case VK_FORMAT_R16_UINT:
    case VK_FORMAT_R16G16B16A16_UINT:
      return 2;
    default:
      return 4;
  }
}

Handle<VkBufferView> Buffer::texelView(VkFormat format) const {
  Device::requireLimit("maxTexelBufferElements", bytes_ / texelBytes(format),
                       device_->limits().maxTexelBufferElements);
  VkBufferViewCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
  info.buffer = get();
  info.format = format;
  info.range = VK_WHOLE_SIZE;
  VkBufferView view = VK_NULL_HANDLE;
  check(vkCreateBufferView(device_->get(), &info, nullptr, &view), "vkCreateBufferView");
  return {device_->get(), view, vkDestroyBufferView};
}

}  // namespace laver
