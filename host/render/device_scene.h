#pragma once
#include <map>
#include <vector>

#include "render/plan.h"
#include "render/scene_data.h"
#include "vulkan/bindings.h"

namespace laver {

/// Everything that one render keeps on the device, bound as shaders/shared/layout.h numbers it.
class DeviceScene {
 public:
  DeviceScene(const Device& device, const SceneData& data, const RenderPlan& plan);

  const Bindings& bindings() const { return bindings_; }
  const Buffer& film() const { return film_; }
  const Buffer& status() const { return status_; }

 private:
  void samples(std::uint32_t written, std::uint32_t read, std::uint64_t slots, VkDeviceSize texel,
               VkFormat format);
  void bindTexels(std::uint32_t binding, const Buffer& buffer, VkFormat format);
  template <class T, class A>
  void uploadTexels(std::uint32_t binding, const char* what, const std::vector<T, A>& data,
                    VkDeviceSize zeros = 0);
  void uploadTexels(std::uint32_t binding, const char* what, std::span<const std::byte> data,
                    VkDeviceSize zeros, VkFormat format);

  const Device& device_;
  Bindings bindings_;
  std::vector<Buffer> buffers_;
  std::vector<Handle<VkBufferView>> views_;
  Buffer film_, status_;
};

}  // namespace laver
