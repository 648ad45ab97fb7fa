#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace laver {

/// How rays traverse the tree (shaders/trace/).
enum class Traversal {
  Lane,      ///< one ray per invocation
  Packet32,  ///< 32 rays that share an origin share a walk
  Packet64   ///< as Packet32, with 64 rays
};

/// "lane", "packet32" or "packet64".
const char* traversalName(Traversal traversal);
bool isPacket(Traversal traversal);

/// A property of an integrator, `xml_NAME` in its GLSL. If `value` is empty, it is the next one or,
/// of a vec3, the next three components of params.properties.
struct KernelProperty {
  std::string type, name, value;  ///< GLSL

  bool operator==(const KernelProperty&) const = default;
};

/// A BSDF of a kernel. Its properties are `xml_NAME` in its text.
struct BsdfText {
  std::string name;
  std::vector<std::string> colors{}, numbers{};  ///< names, in the order of materials' records
  std::string file{}, text{};                    ///< of one of the user's own

  bool operator==(const BsdfText&) const = default;
};

/// The record of a material on the device, in texels of four words: its colours, beside the first
/// of them the BSDF's place in the key; its numbers, four per texel; and for each property that a
/// texture stands for in some material 1 + the texture's place, or 0, four per texel.
struct MaterialLayout {
  std::uint32_t colors = 1, numbers = 0;                  ///< the most that a BSDF has
  std::uint32_t texturedColors = 0, texturedNumbers = 0;  ///< bit i: of the i-th one
  /// Some mesh has a normal map, or a BSDF that depends on the tangent. The last texel of a record
  /// then holds a reference to the map, shared::Texture::uvs, and 1 if there is a tangent.
  bool normalMaps = false, tangents = false;

  bool frames() const { return normalMaps || tangents; }
  std::uint32_t texels() const;
  bool operator==(const MaterialLayout&) const = default;
};

/// Everything that determines the text of a trace kernel. Features that are false, zero or empty
/// are not in the kernel. Names are those of files in the folders of shaders/.
struct TraceKey {
  std::string integrator = "normals";  ///< or "centres" (film/centres.glsl)
  std::string userFile, userText;      ///< of a user's integrator, used instead of `integrator`
  std::string camera = "perspective";
  std::string sampler = "independent";
  std::string background = "none";
  std::vector<BsdfText> bsdfs;        ///< of the scene; empty if the integrator needs none
  std::vector<std::string> textures;  ///< of the scene
  MaterialLayout layout;
  Traversal traversal = Traversal::Lane;
  std::uint32_t stack = 64;      ///< entries of the traversal's stack
  std::uint32_t jumpLevels = 0;  ///< number of tables that `independent` needs, 2 or 3
  bool hits = true;              ///< hits affect the result; otherwise no ray is traced
  bool normals = false;          ///< some mesh has vertex normals that affect the result
  bool materials = false;        ///< the meshes differ in their materials
  bool bsdfRecords = false;      ///< materials' records hold more than an albedo
  bool spheres = false;          ///< some mesh is a sphere
  bool caps = false;             ///< some sphere is given by its nearest point (shared/cap.h)
  bool farParts = false;         ///< parts of the scene are far from the centre of coordinates
  bool slivers = false;          ///< some triangle is too narrow for a plain normal of its plane
  bool farCamera = false;        ///< camera rays start on a plane before the scene
  bool portions = false;         ///< lane only: a dispatch answers one query from part of the tree
  bool lights = false;           ///< point lights affect the result
  bool shapedLights = false;     ///< some of them is a spot or a directional light
  bool manyLights = false;       ///< the lights of a pass take several dispatches
  bool lockstep = false;         ///< the 8 lanes of a subgroup leave loops over bounces together
  bool bounces = false;          ///< rays may start on surfaces
  bool emission = false;         ///< some mesh emits light
  bool texturedLights = false;   ///< textures stand for radiances
  bool byteImages = false,
       floatImages = false;                ///< formats of the images of textures and background
  bool adaptive = false;                   ///< sample counts vary by cell
  bool signedValues = false;               ///< samples with negative values are kept
  bool storageTexels = false;              ///< texels are in storage buffers
  std::vector<KernelProperty> properties;  ///< of the integrator, in the order of its row

  bool operator==(const TraceKey&) const = default;
};

/// Everything that determines the text of a gather kernel, which reconstructs.
struct GatherKey {
  std::string filter = "gaussian_narrow";
  std::uint32_t apron = 2;  ///< pixels on each side that a sample can reach
  bool strips = false;      ///< film/gather_strip.glsl, for subgroups of 8 lanes
  bool adaptive = false;
  bool storageTexels = false;

  bool operator==(const GatherKey&) const = default;
};

}  // namespace laver
