#pragma once
#include <volk.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"
#include "render/choices.h"
#include "render/options.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace laver {

/// Space of the kernels: p' = scale * (p - centre), so that all vertices lie in [-1, 1]^3. The
/// scale is a power of two. Without meshes the space is that of the scene.
struct Normalisation {
  glm::dvec3 centre{0.0};
  double scale = 1.0;
  glm::dvec3 apply(glm::dvec3 p) const { return (p - centre) * scale; }
};
Normalisation normalisationOf(const Scene& scene);

/// A box of all primitives in the scene's space; lo.x > hi.x where there are none.
struct Bounds {
  glm::dvec3 lo, hi;
};
Bounds boundsOf(const Scene& scene);

/// A scene in the memory layout of the kernels; empty arrays are not uploaded.
struct Packed {
  Normalisation space;
  double diagonal = 0.0;  ///< of the box of all primitives, in the scene's space
  Bvh bvh;
  std::vector<std::byte>
      attributes;  ///< shared::Attributes per triangle, in the order of the leaves
  std::vector<glm::vec4> normals;
  std::vector<std::uint32_t> materials;  ///< records of Uploads::layout, one per mesh
  std::vector<shared::Light> lights;
  std::vector<shared::Jump> jumps;
  std::vector<shared::Texture> textures;
  std::vector<glm::vec2> uvs;              ///< three per triangle with a texture
  std::vector<std::uint32_t> images;       ///< all images and their tables
  std::vector<shared::Emission> emission;  ///< one per mesh
  std::vector<shared::Source> sources;     ///< of light sampling
  shared::Params params{};
  VkFormat attributeFormat = VK_FORMAT_R32G32B32A32_UINT;
  std::uint64_t triangles = 0;           ///< uploaded, including spheres
  std::uint64_t collapsedTriangles = 0;  ///< two corners coincide after rounding to float
  double buildSeconds = 0;               ///< of the tree
};

/// Rounds the scene to float, builds the tree and packs all arrays.
Packed pack(const Scene& scene, const RenderOptions& options, const Uploads& uploads);

/// An array of a scene on the device.
struct DeviceArray {
  std::uint32_t binding;
  const char* name;  ///< for messages
  std::span<const std::byte> bytes;
  VkFormat format;
  std::uint64_t zeros;  ///< number of zero bytes appended
  bool decidesPicture;  ///< its contents affect the picture
};

/// All arrays, in the order in which they are uploaded and hashed.
std::vector<DeviceArray> arraysOf(const Packed& packed);

/// Bytes of all arrays, with the zeros appended.
std::uint64_t bytesOf(const Packed& packed);

/// A hash of everything that affects the values of a picture, except the sample count.
std::string contentOf(const Packed& packed, const Choices& choices);

}  // namespace laver
