#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "kernels/keys.h"
#include "render/tiling.h"
#include "vulkan/device_info.h"

namespace laver {

struct VulkanOptions;

/// One decision of a render in words.
struct Reason {
  std::string what, choice, why;
  std::string saving;  ///< beside bytes; empty: none
  std::uint64_t bytesNotUploaded = 0;
};

/// One of the pictures that are made of a scene from one upload.
struct PictureChoice {
  std::vector<std::string> channels;  ///< in the file
  TraceKey key;
  bool centres = false;  ///< not samples, but the ray through each pixel's centre
  /// Rays that hit nothing show black, so that only what the scene covers is traced.
  bool blackMiss = false;
  IntegratorUse shown;
};

/// What of the scene goes to the device, for all its pictures together.
struct Uploads {
  bool primitives = true;   ///< and their tree
  bool attributes = false;  ///< which material and normals a triangle has
  bool normals = false;     ///< vertex normals
  bool materials = false;   ///< a record per mesh
  bool textures = false;    ///< a texture record per mesh, texture coordinates
  bool lights = false;
  bool background = false;
  bool emission = false;         ///< what meshes emit, and the light sources of light sampling
  std::uint32_t jumpLevels = 0;  ///< of the tables that `independent` needs
  bool noriTable = false;        ///< filter weights from Nori's table
  std::uint32_t indexBytes = 4;  ///< of an index in the attributes of a triangle: 1, 2 or 4
  std::vector<std::string> bsdfs, textureKinds;  ///< numbered in this order in the records
};

/// Every decision of a render, made before it starts, each with its reason. The tree alone says
/// more: how deep the traversal's stack must be.
struct Choices {
  std::vector<PictureChoice> pictures;  ///< the scene's own first
  GatherKey gather;
  Uploads uploads;
  Traversal traversal = Traversal::Lane;
  Crop core;  ///< pixels that are wanted
  Tiling tiling;
  std::vector<Reason> reasons;
};

/// What the pictures of a scene need; it depends on no device.
Uploads uploadsOf(const Scene& scene, const RenderOptions& options);

/// Decides. Throws Error(Usage) for an unknown traversal and Error(Device) where the device cannot.
Choices choose(const Scene& scene, const RenderOptions& options, const VulkanOptions& vulkan,
               const DeviceInfo& device);

/// Names of the parts of the keys that generalise() makes general: for tests and benches, which
/// show that a picture keeps its bits and what leaving a part out saves.
const std::vector<std::string>& generalParts();

/// The choices as if the scene needed everything that these parts stand for.
Choices generalised(Choices choices, const std::vector<std::string>& parts);

/// Bytes that hold any index of a triangle's attributes: 1, 2 or 4. Normal 0 is NO_NORMAL.
std::uint32_t indexBytesOf(const Scene& scene, bool normals);

/// The form of the attributes on the device.
VkFormat attributeFormat(const Uploads& uploads);

/// Entries of the traversal's stack that a tree needs, rounded up so that scenes alike in size
/// share a kernel; what the key has where that suffices.
std::uint32_t stackFor(std::uint32_t guess, std::uint32_t needed);

}  // namespace laver
