#pragma once
#include <volk.h>

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bvh/bvh.h"
#include "render/choices.h"
#include "render/options.h"
#include "render/space.h"
#include "render/split_meshes.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace laver {

/// A scene in the memory layout of the kernels; empty arrays are not uploaded.
struct Packed {
  Normalisation space;
  glm::dvec3 eye{0.0};    ///< the camera, in device coordinates
  double diagonal = 0.0;  ///< of the box of all primitives, in the scene's space
  std::vector<std::optional<SplitMesh>> splits;  ///< of the meshes; empty where none is split
  bool isSplit(std::size_t mesh) const { return mesh < splits.size() && splits[mesh]; }
  Bvh bvh;  ///< behind its triangles, outside of the tree, stand caps and whole light sources
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
