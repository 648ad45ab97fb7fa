#include "lab/chart/methods/tracer.h"

#include <fmt/format.h>

#include <chrono>
#include <deque>
#include <optional>

#include "kernels/compose.h"
#include "kernels/modules.h"
#include "lab/chart/methods/quantise.h"
#include "render/stopwatch.h"
#include "shared/charted.h"
#include "vulkan/bindings.h"
#include "vulkan/kernel.h"

namespace laver::chart {
namespace {

static_assert(sizeof(MethodRay) == 32);

constexpr std::array kTypes = {
    VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER,
    VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
    VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};

/// A texel buffer with its view.
struct Texels {
  Texels(const Device& device, const char* what, std::span<const std::byte> data)
      : buffer(device, what, Buffer::Use::Texels, data.size()),
        view(buffer.texelView(VK_FORMAT_R32G32B32A32_UINT)) {
    buffer.upload(data);
  }
  Buffer buffer;
  Handle<VkBufferView> view;
};

template <class T>
std::span<const std::byte> bytesOf(const T& list) {
  return std::as_bytes(std::span(list));
}

}  // namespace

struct MethodTracer::Impl {
  Impl(const std::string& wanted, const Bvh& bvh)
      : device(choosePhysicalDevice(instance, wanted)),
        bindings(device, kTypes),
        stack(bvh.stack),
        root(bvh.root) {
    const Bvh tight = withTightBoxes(bvh);
    nodes.emplace_back(device, "nodes", bytesOf(bvh.nodes));
    nodes.emplace_back(device, "nodes", bytesOf(tight.nodes));
    nodes.emplace_back(device, "nodes", bytesOf(quantised(bvh)));
    nodes.emplace_back(device, "nodes", bytesOf(quantised(tight)));
    triangles.emplace(device, "triangles", bytesOf(bvh.triangles));
    bindings.bind(shared::CHARTED_TRIANGLES, triangles->view.get());
  }

  void reserve(std::span<const MethodRay> list) {
    rays.emplace(device, "rays", std::as_bytes(list));
    hits = Buffer(device, "hits", Buffer::Use::Storage, list.size() * 16);
    ids = Buffer(device, "ids", Buffer::Use::Storage, list.size() * 4);
    bindings.bind(shared::CHARTED_RAYS, rays->view.get());
    bindings.bind(shared::CHARTED_HITS, hits);
    bindings.bind(shared::CHARTED_IDS, ids);
  }

  Instance instance{false};
  Device device;
  Bindings bindings;
  std::uint32_t stack, root;
  std::deque<Texels> nodes;  // as built, tight, and both quantised
  std::optional<Texels> triangles, rays;
  Buffer hits, ids;
  std::optional<Kernel> kernel;
};

MethodTracer::MethodTracer(const std::string& device, const Bvh& bvh)
    : impl_(std::make_unique<Impl>(device, bvh)) {}
MethodTracer::~MethodTracer() = default;

void MethodTracer::use(const Method& method) {
  const std::string text = fmt::format(
      "#version 460\n#extension GL_GOOGLE_cpp_style_line_directive : require\n"
      "#extension GL_EXT_control_flow_attributes : require\n"
      "#extension GL_EXT_samplerless_texture_functions : require\n"
      "const uint STACK = {}u;\nconst uint TRIANGLES = {}u;\nconst uint BOXES = {}u;\n"
      "const bool QUANTISED = {};\n#include \"charted/methods.glsl\"\n",
      impl_->stack, method.triangles, method.boxes, method.quantised);
  const Module module = moduleOf(expandIncludes(text, "methods"));
  impl_->kernel.emplace(impl_->device, impl_->bindings, module.words, sizeof(glm::uvec4));
  const std::size_t form =
      (method.boxes == shared::BOXES_OURS ? 0U : 1U) + (method.quantised ? 2U : 0U);
  impl_->bindings.bind(shared::CHARTED_NODES, impl_->nodes[form].view.get());
}

std::vector<MethodHit> MethodTracer::trace(std::span<const MethodRay> rays, double& seconds) {
  impl_->reserve(rays);
  const glm::uvec4 count(rays.size(), impl_->root, 0, 0);
  seconds = 0;
  {
    const Stopwatch watch(seconds);
    impl_->device.run([&](VkCommandBuffer commands) {
      impl_->kernel->dispatch(commands, impl_->bindings, std::as_bytes(std::span(&count, 1)),
                              {(count.x + 63) / 64, 1, 1});
    });
  }
  std::vector<glm::vec4> found(rays.size());
  std::vector<std::uint32_t> ids(rays.size());
  impl_->hits.download(std::as_writable_bytes(std::span(found)));
  impl_->ids.download(std::as_writable_bytes(std::span(ids)));
  std::vector<MethodHit> hits;
  for (std::size_t i = 0; i < rays.size(); ++i)
    hits.push_back({glm::vec3(found[i]), found[i].w, ids[i]});
  return hits;
}

}  // namespace laver::chart
