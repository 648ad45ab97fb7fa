#include "lab/hypothesis/bsdf_sampler.h"

#include <deque>

#include "kernels/compose.h"
#include "kernels/modules.h"
#include "render/device_scene.h"
#include "render/materials.h"
#include "render/packed.h"
#include "vulkan/bindings.h"
#include "vulkan/kernel.h"

namespace laver {
namespace {

static_assert(sizeof(BsdfQuestion) == 48 && sizeof(BsdfAnswer) == 48);
constexpr std::uint32_t kInput = shared::BINDINGS, kOutput = shared::BINDINGS + 1;

/// A triangle for each BSDF, whose second and third weight are u and v. Its corners have the order
/// in which they are stored.
Scene sceneOf(const std::vector<Bsdf>& bsdfs) {
  Scene scene;
  for (const Bsdf& bsdf : bsdfs) {
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}};  // u along +x
    mesh.uvs = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.bsdf = bsdf;
  }
  return scene;
}

std::vector<VkDescriptorType> typesOfBindings() {
  const auto production = bindingTypes();
  std::vector<VkDescriptorType> types(production.begin(), production.end());
  types.insert(types.end(), 2, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
  return types;
}

Kernel kernelOf(const Device& device, const Bindings& bindings, const Scene& scene) {
  TraceKey key;
  key.bsdfs = bsdfsOf(scene);
  key.layout = layoutOf(scene);
  key.textures = texturesOf(scene);
  key.materials = key.bsdfRecords = true;
  const std::string text = materialText(key) + std::string(shaderText("trace/sample_bsdf.glsl"));
  return {device, bindings, moduleOf(composeWith(key, text)).words, sizeof(shared::Pass)};
}

Packed packedOf(const Scene& scene) {
  Uploads uploads;
  uploads.attributes = uploads.materials = uploads.textures = true;
  uploads.layout = layoutOf(scene);
  uploads.bsdfs = bsdfsOf(scene);
  uploads.textureKinds = texturesOf(scene);
  return pack(scene, {}, uploads);
}

}  // namespace

struct BsdfSampler::Impl {
  Impl(const Device& d, const Scene& scene)
      : device(d),
        packed(packedOf(scene)),
        bindings(d, typesOfBindings()),
        kernel(kernelOf(d, bindings, scene)) {
    for (const DeviceArray& array : arraysOf(packed)) {
      if (array.bytes.empty()) continue;
      buffers.emplace_back(device, array.name, Buffer::Use::Texels, array.bytes.size());
      buffers.back().upload(array.bytes);
      views.push_back(buffers.back().texelView(array.format));
      bindings.bind(array.binding, views.back().get());
    }
  }

  const Device& device;
  Packed packed;
  Bindings bindings;
  Kernel kernel;
  std::vector<Handle<VkBufferView>> views;
  std::deque<Buffer> buffers;
};

BsdfSampler::BsdfSampler(const Device& device, const std::vector<Bsdf>& bsdfs)
    : impl_(std::make_unique<Impl>(device, sceneOf(bsdfs))) {}
BsdfSampler::~BsdfSampler() = default;

std::vector<BsdfAnswer> BsdfSampler::answers(std::size_t which,
                                             std::span<const BsdfQuestion> questions) const {
  const Buffer input(impl_->device, "questions", Buffer::Use::Storage, questions.size_bytes());
  input.upload(std::as_bytes(questions));
  impl_->bindings.bind(kInput, input);
  std::vector<BsdfAnswer> result(questions.size());
  const Buffer output(impl_->device, "answers", Buffer::Use::Storage,
                      result.size() * sizeof(BsdfAnswer));
  impl_->bindings.bind(kOutput, output);
  shared::Pass pass{};
  pass.region = {static_cast<std::uint32_t>(questions.size()), static_cast<std::uint32_t>(which), 0,
                 0};
  impl_->device.run([&](VkCommandBuffer commands) {
    impl_->kernel.dispatch(commands, impl_->bindings, std::as_bytes(std::span(&pass, 1)),
                           {(pass.region.x + 63) / 64, 1, 1});
  });
  output.download(std::as_writable_bytes(std::span(result)));
  return result;
}

}  // namespace laver
