#include "trace/ray_tracer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <deque>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "kernels/compose.h"
#include "kernels/modules.h"
#include "render/choices.h"
#include "render/device_scene.h"
#include "render/traversal.h"
#include "vulkan/bindings.h"
#include "vulkan/kernel.h"

namespace laver::test {

std::string testText(const std::string& name) {
  std::ifstream file(std::string(LAVER_SOURCE_DIR) + "/tests/trace/" + name);
  if (!file) throw std::runtime_error(name + " cannot be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

namespace {

/// Rays per dispatch: 32 MiB.
constexpr std::size_t kRays = std::size_t{1} << 20;
constexpr std::uint32_t kInput = shared::BINDINGS, kOutput = shared::BINDINGS + 1;
/// Workgroups per row of a dispatch.
constexpr std::uint32_t kRow = 1024;

static_assert(sizeof(TestRay) == 32 && sizeof(TestHit) == 16);

std::vector<VkDescriptorType> testBindingTypes() {
  const auto production = bindingTypes();
  std::vector<VkDescriptorType> types(production.begin(), production.end());
  types.resize(shared::BINDINGS + 2, VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER);
  types[kOutput] = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  return types;
}

TraceKey keyOf(const std::string& traversal, const Bvh& bvh) {
  TraceKey key;
  for (const Traversal t : {Traversal::Lane, Traversal::Packet32, Traversal::Packet64})
    if (traversal == traversalName(t)) key.traversal = t;
  key.stack = stackFor(64, bvh.stack);  // so that most trees share a kernel
  key.spheres = std::any_of(bvh.triangles.begin(), bvh.triangles.end(),
                            [](const auto& t) { return t.flipped == shared::IS_SPHERE; });
  return key;
}

}  // namespace

const Kernel& TestKernels::get(const Device& device, const Bindings& bindings,
                               const std::string& text) {
  const auto found = kernels_.find(text);
  if (found != kernels_.end()) return found->second;
  return kernels_
      .try_emplace(text, device, bindings, moduleOf(text).words,
                   static_cast<std::uint32_t>(sizeof(shared::Pass)))
      .first->second;
}

struct RayTracer::Impl {
  Impl(const Device& d, const Bvh& bvh, const std::string& traversal,
       std::shared_ptr<TestKernels> theKernels)
      : device(d),
        bindings(d, testBindingTypes()),
        params(d, "parameters", Buffer::Use::Uniform, sizeof(shared::Params)),
        status(d, "status", Buffer::Use::Storage, sizeof(shared::Status)),
        output(d, "hits", Buffer::Use::Storage, kRays * sizeof(TestHit)),
        key(keyOf(traversal, bvh)),
        kernels(std::move(theKernels)) {
    shared::Params values{};
    values.root = bvh.root;
    values.packetWindow = packetWindow(bvh.triangles.size());
    params.upload(std::as_bytes(std::span(&values, 1)));
    bindings.bind(shared::BIND_PARAMS, params);
    bindings.bind(shared::BIND_STATUS, status);
    bindings.bind(kOutput, output);
    uploadTexels(shared::BIND_NODES, std::as_bytes(std::span(bvh.nodes)));
    uploadTexels(shared::BIND_TRIANGLES, std::as_bytes(std::span(bvh.triangles)));
    input = &bindTexels(kInput, kRays * sizeof(TestRay));
  }

  Buffer& bindTexels(std::uint32_t binding, std::size_t bytes) {
    buffers.emplace_back(device, "texels", Buffer::Use::Texels, bytes);
    views.push_back(buffers.back().texelView(VK_FORMAT_R32G32B32A32_UINT));
    bindings.bind(binding, views.back().get());
    return buffers.back();
  }

  /// Packets read up to MAX_LEAF - 1 triangles beyond the last leaf.
  void uploadTexels(std::uint32_t binding, std::span<const std::byte> data) {
    const std::size_t zeros = (shared::MAX_LEAF - 1) * sizeof(shared::Triangle);
    const Buffer& buffer = bindTexels(binding, data.size() + zeros);
    buffer.fillZero();
    if (!data.empty()) buffer.upload(data);
  }

  /// The kernel of a query, a function of trace_rays.glsl.
  const Kernel& kernelOf(const std::string& query) {
    const Kernel*& kernel = kernelOfQuery[query];
    if (kernel == nullptr) {
      const std::string main =
          fmt::format("#define QUERY {}\n{}", query, testText("trace_rays.glsl"));
      kernel = &kernels->get(device, bindings, composeWith(key, main));
    }
    return *kernel;
  }

  void run(const Kernel& kernel, shared::Pass pass, std::size_t count) {
    pass.region.x = static_cast<std::uint32_t>(count);
    const std::uint32_t groups = (pass.region.x + 63) / 64;
    const std::uint32_t width = std::min(groups, kRow);
    const auto start = std::chrono::steady_clock::now();
    device.run([&](VkCommandBuffer commands) {
      kernel.dispatch(commands, bindings, std::as_bytes(std::span(&pass, 1)),
                      {width, (groups + width - 1) / width, 1});
    });
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  /// Calls part(begin, end) for pieces of whole blocks that fit one dispatch.
  template <class Part>
  void inParts(std::size_t count, const Part& part) {
    seconds = 0;
    status.fillZero();
    for (std::size_t i = 0; i < count; i += kRays) part(i, std::min(count, i + kRays));
    shared::Status counts{};
    status.download(std::as_writable_bytes(std::span(&counts, 1)));
    incomplete = counts.incomplete;
  }

  const Device& device;
  Bindings bindings;
  Buffer params, status, output;
  std::vector<Handle<VkBufferView>> views;
  std::deque<Buffer> buffers;
  const Buffer* input = nullptr;
  TraceKey key;
  std::shared_ptr<TestKernels> kernels;
  std::map<std::string, const Kernel*> kernelOfQuery;
  double seconds = 0;
  std::uint32_t incomplete = 0;
};

RayTracer::RayTracer(const Device& device, const Bvh& bvh, const std::string& traversal,
                     std::shared_ptr<TestKernels> kernels)
    : impl_(std::make_unique<Impl>(device, bvh, traversal, std::move(kernels))) {}
RayTracer::~RayTracer() = default;

std::vector<TestHit> RayTracer::closest(std::span<const TestRay> rays) {
  return trace("traceFromOne", rays);
}

std::vector<TestHit> RayTracer::closestOfAny(std::span<const TestRay> rays) {
  return trace("traceRays", rays);
}

std::vector<TestHit> RayTracer::trace(const std::string& query, std::span<const TestRay> rays) {
  const Kernel& kernel = impl_->kernelOf(query);
  std::vector<TestHit> hits(rays.size());
  impl_->inParts(rays.size(), [&](std::size_t begin, std::size_t end) {
    impl_->input->upload(std::as_bytes(rays.subspan(begin, end - begin)));
    impl_->run(kernel, {}, end - begin);
    impl_->output.download(std::as_writable_bytes(std::span(hits).subspan(begin, end - begin)));
  });
  return hits;
}

std::vector<std::uint32_t> RayTracer::visible(glm::vec3 light, std::span<const glm::vec3> points) {
  const Kernel& kernel = impl_->kernelOf("seePoints");
  std::vector<glm::vec4> texels(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) texels[i] = glm::vec4(points[i], 0.0F);
  shared::Pass pass{};
  std::memcpy(&pass.core, &light, sizeof light);
  std::vector<glm::vec4> seen(points.size());
  impl_->inParts(points.size(), [&](std::size_t begin, std::size_t end) {
    impl_->input->upload(std::as_bytes(std::span(texels).subspan(begin, end - begin)));
    impl_->run(kernel, pass, end - begin);
    impl_->output.download(std::as_writable_bytes(std::span(seen).subspan(begin, end - begin)));
  });
  std::vector<std::uint32_t> clear;
  for (const glm::vec4& s : seen) clear.push_back(static_cast<std::uint32_t>(s.x));
  return clear;
}

double RayTracer::seconds() const { return impl_->seconds; }
std::uint32_t RayTracer::incomplete() const { return impl_->incomplete; }

}  // namespace laver::test
