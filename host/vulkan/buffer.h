#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "vulkan/device.h"

namespace laver {

/// Bytes of a texel of the formats that laver uses.
VkDeviceSize texelBytes(VkFormat format);

/// A buffer with memory of its own on the device; where the host can see that memory, transfers
/// are plain copies, elsewhere they go through a staging buffer.
class Buffer {
 public:
  enum class Use { Uniform, Texels, Storage, StorageTexels };

  Buffer() = default;
  /// `bytes` above 0. Throws Error(Device) where a limit of the device or its memory is passed.
  Buffer(const Device& device, const char* what, Use use, VkDeviceSize bytes);

  VkBuffer get() const { return buffer_.get(); }
  VkDeviceSize bytes() const { return bytes_; }

  void upload(std::span<const std::byte> data) const;
  void download(std::span<std::byte> data) const;
  void fillZero(VkDeviceSize from = 0) const { fill(0, from); }
  void fill(std::uint32_t word, VkDeviceSize from = 0) const;
  /// The first `bytes`: in place where the host reads them at speed, else downloaded to `copy`.
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
  bool cached_ = false;  ///< host memory that is not read past the processor's caches

  struct Staging {};
  Buffer(const Device& device, Staging, VkDeviceSize bytes);
};

}  // namespace laver
