#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/keys.h"
#include "render/space.h"
#include "render/tiling.h"
#include "vulkan/device_info.h"

namespace laver {

struct VulkanOptions;

/// Entries of the traversal's stack. Sufficient for trees of tens of thousands to a million
/// triangles (48 to 63 entries).
constexpr std::uint32_t kLikelyStack = 64;

/// One decision of a render and its reason, as text.
struct Reason {
  std::string what, choice, why;
  std::string saving;  ///< other than bytes; empty: none
  std::uint64_t bytesNotUploaded = 0;
};

/// One of the pictures that are rendered of a scene from one upload.
struct PictureChoice {
  std::vector<std::string> channels;  ///< of the file
  TraceKey key;
  bool centres = false;  ///< one ray through each pixel's centre instead of samples
  /// Rays that hit nothing are black, so that only the part of the film that the scene covers is
  /// traced.
  bool blackMiss = false;
  IntegratorUse integrator;
};

/// The parts of the scene that are uploaded, for all its pictures together.
struct Uploads {
  Normalisation space;      ///< device coordinates
  bool primitives = true;   ///< primitives and their tree
  bool attributes = false;  ///< material and normal indices of triangles
  bool normals = false;     ///< vertex normals
  bool materials = false;   ///< one record per mesh
  bool textures = false;    ///< texture records, texture coordinates
  bool lights = false;
  bool background = false;
  bool emission = false;  ///< radiance that meshes emit, and the light sources of light sampling
  std::uint32_t jumpLevels = 0;  ///< levels of the tables that `independent` needs
  bool noriTable = false;        ///< filter weights from Nori's table
  std::uint32_t indexBytes = 4;  ///< size of an index in the attributes: 1, 2 or 4
  MaterialLayout layout;
  std::vector<BsdfText> bsdfs;            ///< records refer to these indices
  std::vector<std::string> textureKinds;  ///< so do the textures' records
};

/// Every decision of a render, made before it starts, with its reason. Only the depth of the
/// traversal's stack must wait for the tree.
struct Choices {
  std::vector<PictureChoice> pictures;  ///< the scene's own first
  GatherKey gather;
  Uploads uploads;
  Traversal traversal = Traversal::Lane;
  Crop core;                  ///< the film or its crop
  std::vector<Strip> strips;  ///< the pixels of the picture: the core, or a shard of it
  Tiling tiling;
  std::vector<Reason> reasons;
};

/// The uploads that the pictures of a scene need, independent of the device.
Uploads uploadsOf(const Scene& scene, const RenderOptions& options);

/// Makes all decisions. Throws Error(Usage) for an unknown traversal and Error(Device) for one that
/// the device does not support.
Choices choose(const Scene& scene, const RenderOptions& options, const VulkanOptions& vulkan,
               const DeviceInfo& device);

/// Names of the parts that generalised() can make general. Tests and benches use them to show that
/// a picture keeps its bits and how much time leaving a part out saves.
const std::vector<std::string>& generalParts();

/// The choices for a scene that needs everything that these parts stand for.
Choices generalised(Choices choices, const std::vector<std::string>& parts);

/// Size in bytes that holds any index of a triangle's attributes: 1, 2 or 4. Normal 0 is NO_NORMAL.
std::uint32_t indexBytesOf(const Scene& scene, bool normals);

/// The texel format of the attributes on the device.
VkFormat attributeFormat(const Uploads& uploads);

/// Entries of the traversal's stack for a tree that needs `needed`: `guess`, the size in the key,
/// if that suffices, else rounded up so that similar scenes share a kernel.
std::uint32_t stackFor(std::uint32_t guess, std::uint32_t needed);

}  // namespace laver
