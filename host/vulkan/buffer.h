#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "vulkan/device.h"

namespace laver {

/// Size in bytes of a texel of a format that laver uses.
VkDeviceSize texelBytes(VkFormat format);
/// Size in bytes of one of its components.
VkDeviceSize wordBytes(VkFormat format);

/// A buffer with its own device memory. Transfers are plain copies where the host can see that
/// memory, and go through a staging buffer elsewhere.
class Buffer {
 public:
  enum class Use { Uniform, Texels, Storage, StorageTexels };

  Buffer() = default;
  /// `bytes` > 0; `what` names the buffer in errors. Throws Error(Device) if a limit or the memory
  /// of the device is exceeded.
  Buffer(const Device& device, const char* what, Use use, VkDeviceSize bytes);

  VkBuffer get() const { return buffer_.get(); }
  VkDeviceSize bytes() const { return bytes_; }

  void upload(std::span<const std::byte> data) const;
  void download(std::span<std::byte> data) const;
  void fillZero(VkDeviceSize from = 0) const { fill(0, from); }
  void fill(std::uint32_t word, VkDeviceSize from = 0) const;
  /// The first `bytes`: a view of the memory if the host reads it fast, else downloaded to `copy`.
  std::span<const std::byte> contents(VkDeviceSize bytes, std::vector<std::byte>& copy) const;

  /// A view of the whole buffer as texels.
  Handle<VkBufferView> texelView(VkFormat format) const;

 private:
  void allocate(const Device& device, const char* what, VkMemoryPropertyFlags preferred,
                VkMemoryPropertyFlags required);

  const Device* device_ = nullptr;
  VkDeviceSize bytes_ = 0;
  Handle<VkBuffer> buffer_;
  Handle<VkDeviceMemory> memory_;
  std::byte* mapped_ = nullptr;
  bool cached_ = false;  ///< the host reads the memory through its caches

  struct Staging {};
  Buffer(const Device& device, Staging, VkDeviceSize bytes);
};

}  // namespace laver
