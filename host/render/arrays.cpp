// The arrays of a scene on the device, listed once: for the upload, its size, and the hash of what
// decides a picture.
#include "core/hash.h"
#include "kernels/compose.h"
#include "render/packed.h"

namespace laver {

namespace {

template <class T, class A>
std::span<const std::byte> bytes(const std::vector<T, A>& data) {
  return std::as_bytes(std::span(data));
}

}  // namespace

std::vector<DeviceArray> arraysOf(const Packed& p) {
  constexpr VkFormat kTexels = VK_FORMAT_R32G32B32A32_UINT;
  // The lanes of a packet read past the last triangle of a leaf; zeros there are never hit.
  constexpr std::uint64_t kAfterTriangles = (shared::MAX_LEAF - 1) * sizeof(shared::Triangle);
  // A kernel that is not specialised to scenes without lights reads one light, which must be black.
  constexpr std::uint64_t kAfterLights = sizeof(shared::Light);
  return {
      {shared::BIND_NODES, "BVH nodes", bytes(p.bvh.nodes), kTexels, 0, false},
      {shared::BIND_TRIANGLES, "triangles", bytes(p.bvh.triangles), kTexels, kAfterTriangles, true},
      {shared::BIND_ATTRIBUTES, "attributes", p.attributes, p.attributeFormat, 0, true},
      {shared::BIND_NORMALS, "normals", bytes(p.normals), kTexels, 0, true},
      {shared::BIND_MATERIALS, "materials", bytes(p.materials), kTexels, 0, true},
      {shared::BIND_LIGHTS, "lights", bytes(p.lights), kTexels, kAfterLights, true},
      {shared::BIND_JUMPS, "sampler tables", bytes(p.jumps), kTexels, 0, false},
      {shared::BIND_TEXTURES, "textures", bytes(p.textures), kTexels, 0, true},
      {shared::BIND_UVS, "texture coordinates", bytes(p.uvs), VK_FORMAT_R32G32_UINT, 0, true},
      {shared::BIND_EMISSION, "emission", bytes(p.emission), kTexels, 0, true},
      {shared::BIND_SOURCES, "light sources", bytes(p.sources), kTexels, 0, true},
      {shared::BIND_IMAGES, "images", bytes(p.images), VK_FORMAT_R32_UINT, 0, true}};
}

std::uint64_t bytesOf(const Packed& packed) {
  std::uint64_t sum = 0;
  for (const DeviceArray& array : arraysOf(packed)) sum += array.bytes.size();
  return sum;
}

std::string contentOf(const Packed& packed, const Choices& choices) {
  Hash hash;
  shared::Params params = packed.params;
  params.sampleCount = params.root = 0;
  hash.add(std::as_bytes(std::span(&params, 1)));
  TraceKey key = choices.pictures.front().key;
  key.stack = key.jumpLevels = 0;  // depend on the tree and the sample count
  key.traversal = Traversal::Lane;
  key.storageTexels = false;
  GatherKey gather = choices.gather;
  gather.strips = gather.storageTexels = false;
  hash.add(compose(key));
  hash.add(compose(gather));
  for (const DeviceArray& array : arraysOf(packed))
    if (array.decidesPicture) hash.add(array.bytes);
  return hash.text();
}

}  // namespace laver
