#include "render/device_scene.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace laver {
namespace {

constexpr VkFormat kTexels = VK_FORMAT_R32G32B32A32_UINT;

/// A size of at least `bytes` for which lavapipe reuses compiled kernels. It compiles a kernel
/// again when the size of a texel buffer changes between power of two and not, or when bits 0 to 7
/// or 8 to 15 of the size, which it takes for mip levels, change between zero and not (its
/// lp_static_texture_state). The sizes made here are no powers of two and have neither byte zero.
VkDeviceSize stableSize(VkDeviceSize bytes, VkDeviceSize texel) {
  if ((bytes & 0xff00U) == 0) bytes += 0x100;
  return (bytes & 0xffU) == 0 ? bytes + texel : bytes;
}

/// The array with four 32-bit words per texel, as a texel buffer of that format reads it.
std::vector<std::byte> widened(const DeviceArray& array) {
  const VkDeviceSize texel = texelBytes(array.format), word = wordBytes(array.format);
  const std::size_t count = array.bytes.size() / texel;
  std::vector<std::byte> wide(count * 16);
  const std::array<std::uint32_t, 4> missing = {0, 0, 0, 1};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t c = 0; c < 4; ++c) {
      std::uint32_t value = missing[c];
      if (c * word < texel) {
        value = 0;
        std::memcpy(&value, array.bytes.data() + i * texel + c * word, word);
      }
      std::memcpy(wide.data() + i * 16 + c * 4, &value, 4);
    }
  return wide;
}

}  // namespace

std::array<VkDescriptorType, shared::BINDINGS> bindingTypes(bool storageTexels) {
  std::array<VkDescriptorType, shared::BINDINGS> types;
  types.fill(storageTexels ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                           : VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER);
  types[shared::BIND_PARAMS] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  for (const auto b :
       {shared::BIND_SAMPLES, shared::BIND_SAMPLES_Y, shared::BIND_FILM, shared::BIND_STATUS})
    types[b] = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  return types;
}

DeviceScene::DeviceScene(const Device& device, const Packed& packed, const Tiling& tiling,
                         bool storageTexels)
    : device_(device),
      storageTexels_(storageTexels),
      bindings_(device, bindingTypes(storageTexels)) {
  params_ = Buffer(device, "parameters", Buffer::Use::Uniform, sizeof packed.params);
  bindings_.bind(shared::BIND_PARAMS, params_);
  upload(packed.params);
  for (const DeviceArray& array : arraysOf(packed)) upload(array);

  samples_ = samples(shared::BIND_SAMPLES, shared::BIND_SAMPLE_TEXELS, tiling.sampleSlots);
  samplesY_ =
      samples(shared::BIND_SAMPLES_Y, shared::BIND_SAMPLE_Y_TEXELS, (tiling.sampleSlots + 3) / 4);

  film_ =
      Buffer(device, "film", Buffer::Use::Storage, tiling.bandPixels * sizeof(shared::FilmPixel));
  bindings_.bind(shared::BIND_FILM, film_);
  status_ = Buffer(device, "status", Buffer::Use::Storage, sizeof(shared::Status));
  bindings_.bind(shared::BIND_STATUS, status_);
  status_.fillZero();
  upload(std::span<const shared::Count>());
  upload(std::span<const shared::Work>());
}

void DeviceScene::upload(const shared::Params& params) const {
  params_.upload(std::as_bytes(std::span(&params, 1)));
}

void DeviceScene::upload(std::span<const shared::Node> nodes) {
  upload(DeviceArray{shared::BIND_NODES, "BVH nodes", std::as_bytes(nodes), kTexels, 0, false});
}

void DeviceScene::reserveAnswers(std::uint64_t answers) {
  const VkDeviceSize bytes = sizeof(shared::Status) + answers * sizeof(std::uint32_t);
  if (bytes <= status_.bytes()) return;
  std::vector<std::byte> kept(status_.bytes());
  status_.download(kept);
  status_ = Buffer(device_, "answers to queries", Buffer::Use::Storage, bytes);
  status_.upload(kept);
  bindings_.bind(shared::BIND_STATUS, status_);
}

void DeviceScene::upload(std::span<const shared::Count> counts) {
  refill(counts_, shared::BIND_COUNTS, "sample counts", std::as_bytes(counts));
}

void DeviceScene::upload(std::span<const shared::Work> work) {
  refill(work_, shared::BIND_WORK, "lists of work", std::as_bytes(work));
}

void DeviceScene::refill(Texels& texels, std::uint32_t binding, const char* name,
                         std::span<const std::byte> data) {
  const VkDeviceSize bytes =
      stableSize(std::max<VkDeviceSize>(data.size(), VkDeviceSize{3} * 16), 16);
  if (texels.buffer.bytes() < bytes) {
    texels.buffer = this->texels(name, bytes);
    texels.view = bindTexels(binding, texels.buffer, kTexels);
  }
  if (!data.empty()) texels.buffer.upload(data);
}

Buffer DeviceScene::samples(std::uint32_t written, std::uint32_t read, std::uint64_t texels) {
  const auto use = storageTexels_ ? Buffer::Use::Storage : Buffer::Use::StorageTexels;
  Buffer buffer(device_, "samples", use, stableSize(texels * 16, 16));
  bindings_.bind(written, buffer);
  views_.push_back(bindTexels(read, buffer, VK_FORMAT_R32G32B32A32_SFLOAT));
  return buffer;
}

void DeviceScene::poisonSamples() const {
  for (const Buffer* buffer : {&samples_, &samplesY_}) buffer->fill(0xffffffffU);
}

Buffer DeviceScene::texels(const char* name, VkDeviceSize bytes) const {
  return {device_, name, storageTexels_ ? Buffer::Use::Storage : Buffer::Use::Texels, bytes};
}

Handle<VkBufferView> DeviceScene::bindTexels(std::uint32_t binding, const Buffer& buffer,
                                             VkFormat format) const {
  if (storageTexels_) {
    bindings_.bind(binding, buffer);
    return {};
  }
  Handle<VkBufferView> view = buffer.texelView(format);
  bindings_.bind(binding, view.get());
  return view;
}

void DeviceScene::upload(const DeviceArray& array) {
  if (storageTexels_ && texelBytes(array.format) < 16) {
    const std::vector<std::byte> wide = widened(array);
    upload(DeviceArray{array.binding, array.name, wide, kTexels, array.zeros, false});
    return;
  }
  // Every binding needs a buffer, even if the kernel does not read it.
  const VkDeviceSize texel = texelBytes(array.format);
  const VkDeviceSize bytes = std::max<VkDeviceSize>(array.bytes.size() + array.zeros, 3 * texel);
  Buffer buffer = texels(array.name, stableSize(bytes, texel));
  if (array.zeros != 0) buffer.fillZero(array.bytes.size());
  if (!array.bytes.empty()) buffer.upload(array.bytes);
  views_.push_back(bindTexels(array.binding, buffer, array.format));
  buffers_.push_back(std::move(buffer));
}

}  // namespace laver
