#include "render/device_scene.h"

#include <array>

#include "render/attribute_form.h"

namespace laver {
namespace {

constexpr VkFormat kTexels = VK_FORMAT_R32G32B32A32_UINT;

/// lavapipe compiles a kernel anew where the bytes of a texel buffer become or cease to be a power
/// of two, or where bits 0 to 7 or 8 to 15 of them, which it takes for mip levels, become or cease
/// to be all zero (its lp_static_texture_state): of none they are.
VkDeviceSize alike(VkDeviceSize bytes, VkDeviceSize texel) {
  if ((bytes & 0xff00U) == 0) bytes += 0x100;
  return (bytes & 0xffU) == 0 ? bytes + texel : bytes;
}

}  // namespace

std::array<VkDescriptorType, shared::BINDINGS> bindingTypes() {
  std::array<VkDescriptorType, shared::BINDINGS> types;
  types.fill(VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER);
  types[shared::BIND_PARAMS] = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  for (const auto b :
       {shared::BIND_SAMPLES, shared::BIND_SAMPLES_Y, shared::BIND_FILM, shared::BIND_STATUS})
    types[b] = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  return types;
}

DeviceScene::DeviceScene(const Device& device, const SceneData& data, const RenderPlan& plan)
    : device_(device), bindings_(device, bindingTypes()) {
  params_ = Buffer(device, "parameters", Buffer::Use::Uniform, sizeof data.params);
  bindings_.bind(shared::BIND_PARAMS, params_);
  upload(data.params);

  uploadTexels(shared::BIND_NODES, "BVH nodes", data.bvh.nodes);
  // A packet's lanes read a leaf's triangles and what follows, which must not be met.
  uploadTexels(shared::BIND_TRIANGLES, "triangles", data.bvh.triangles,
               (shared::MAX_LEAF - 1) * sizeof(shared::Triangle));
  uploadTexels(shared::BIND_ATTRIBUTES, "attributes", attributeBytes(data), 0,
               attributeFormat(data.constants));
  uploadTexels(shared::BIND_NORMALS, "normals", data.normals);
  uploadTexels(shared::BIND_MATERIALS, "materials", data.materials);
  // Kernels that do not know that there is no light look at one, which must be black.
  uploadTexels(shared::BIND_LIGHTS, "lights", data.lights, sizeof(shared::Light));
  uploadTexels(shared::BIND_JUMPS, "sampler tables", data.jumps);
  uploadTexels(shared::BIND_TEXTURES, "textures", data.textures);
  uploadTexels(shared::BIND_UVS, "texture coordinates", data.uvs, 0, VK_FORMAT_R32G32_UINT);
  uploadTexels(shared::BIND_IMAGES, "pictures", data.images, 0, VK_FORMAT_R32_UINT);

  samples_ = samples(shared::BIND_SAMPLES, shared::BIND_SAMPLE_TEXELS, plan.sampleSlots);
  samplesY_ =
      samples(shared::BIND_SAMPLES_Y, shared::BIND_SAMPLE_Y_TEXELS, (plan.sampleSlots + 3) / 4);

  film_ = Buffer(device, "film", Buffer::Use::Storage, plan.bandPixels * sizeof(shared::FilmPixel));
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

void DeviceScene::upload(std::span<const shared::Count> counts) {
  refill(counts_, shared::BIND_COUNTS, "sample counts", std::as_bytes(counts));
}

void DeviceScene::upload(std::span<const shared::Work> work) {
  refill(work_, shared::BIND_WORK, "lists of work", std::as_bytes(work));
}

void DeviceScene::refill(Texels& texels, std::uint32_t binding, const char* what,
                         std::span<const std::byte> data) {
  const VkDeviceSize bytes = alike(std::max<VkDeviceSize>(data.size(), VkDeviceSize{3} * 16), 16);
  if (texels.buffer.bytes() < bytes) {
    texels.buffer = Buffer(device_, what, Buffer::Use::Texels, bytes);
    texels.view = texels.buffer.texelView(kTexels);
    bindings_.bind(binding, texels.view.get());
  }
  if (!data.empty()) texels.buffer.upload(data);
}

Buffer DeviceScene::samples(std::uint32_t written, std::uint32_t read, std::uint64_t texels) {
  Buffer buffer(device_, "samples", Buffer::Use::StorageTexels, alike(texels * 16, 16));
  bindings_.bind(written, buffer);
  bindTexels(read, buffer, VK_FORMAT_R32G32B32A32_SFLOAT);
  return buffer;
}

void DeviceScene::poisonSamples() const {
  for (const Buffer* buffer : {&samples_, &samplesY_}) buffer->fill(0xffffffffU);
}

void DeviceScene::bindTexels(std::uint32_t binding, const Buffer& buffer, VkFormat format) {
  views_.push_back(buffer.texelView(format));
  bindings_.bind(binding, views_.back().get());
}

template <class T, class A>
void DeviceScene::uploadTexels(std::uint32_t binding, const char* what,
                               const std::vector<T, A>& data, VkDeviceSize zeros, VkFormat format) {
  // A kernel that does not read the binding still needs something bound there.
  const VkDeviceSize texel = texelBytes(format);
  const VkDeviceSize bytes = std::max<VkDeviceSize>(data.size() * sizeof(T) + zeros, 3 * texel);
  Buffer buffer(device_, what, Buffer::Use::Texels, alike(bytes, texel));
  if (zeros != 0) buffer.fillZero(data.size() * sizeof(T));
  if (!data.empty()) buffer.upload(std::as_bytes(std::span(data)));
  bindTexels(binding, buffer, format);
  buffers_.push_back(std::move(buffer));
}

}  // namespace laver
