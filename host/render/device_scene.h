#pragma once
#include <array>
#include <span>
#include <vector>

#include "render/packed.h"
#include "vulkan/bindings.h"

namespace laver {

/// The descriptor type of each binding of shared/layout.h; `storageTexels`: TraceKey.
std::array<VkDescriptorType, shared::BINDINGS> bindingTypes(bool storageTexels = false);

/// Everything that one render stores on the device, bound as in shared/layout.h.
class DeviceScene {
 public:
  DeviceScene(const Device& device, const Packed& packed, const Tiling& tiling, bool storageTexels);

  const Bindings& bindings() const { return bindings_; }
  const Buffer& film() const { return film_; }
  const Buffer& status() const { return status_; }
  const Buffer& samples() const { return samples_; }
  const Buffer& samplesY() const { return samplesY_; }
  /// Sets all samples to NaN.
  void poisonSamples() const;

  /// Sets the parameters of the following dispatches.
  void upload(const shared::Params& params) const;
  /// Replaces the nodes by those of another tree of the same primitives.
  void upload(std::span<const shared::Node> nodes);
  /// Makes room for answers behind the status (trace/portions.glsl) and keeps the existing ones.
  void reserveAnswers(std::uint64_t answers);
  /// Buffers of adaptive sampling: the counts of a band's cells, and the work of a pass.
  void upload(std::span<const shared::Count> counts);
  void upload(std::span<const shared::Work> work);

 private:
  struct Texels {
    Buffer buffer;
    Handle<VkBufferView> view;
  };
  void refill(Texels& texels, std::uint32_t binding, const char* name,
              std::span<const std::byte> data);
  Buffer samples(std::uint32_t written, std::uint32_t read, std::uint64_t texels);
  Buffer texels(const char* name, VkDeviceSize bytes) const;
  Handle<VkBufferView> bindTexels(std::uint32_t binding, const Buffer& buffer,
                                  VkFormat format) const;
  void upload(const DeviceArray& array);

  const Device& device_;
  bool storageTexels_;
  Bindings bindings_;
  std::vector<Buffer> buffers_;
  std::vector<Handle<VkBufferView>> views_;
  Buffer params_, film_, status_, samples_, samplesY_;
  Texels counts_, work_;
};

}  // namespace laver
