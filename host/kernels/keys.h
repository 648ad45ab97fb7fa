#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace laver {

/// How rays go through the tree (shaders/trace/).
enum class Traversal {
  Lane,      ///< a ray per invocation
  Packet32,  ///< 32 rays of one origin share a walk
  Packet64   ///< 64 do
};

/// "lane", "packet32" or "packet64".
const char* traversalName(Traversal traversal);
bool isPacket(Traversal traversal);

/// A property of an integrator, `xml_NAME` in its GLSL. Without a value property i of the row is
/// component i of params.properties.
struct KernelProperty {
  std::string type, name, value;  ///< GLSL

  bool operator==(const KernelProperty&) const = default;
};

/// A BSDF of the user's own. Its float properties are `xml_NAME` in its text.
struct UserBsdfText {
  std::string name, file, text;
  std::vector<std::string> numbers;  ///< names, in the order of the materials' records

  bool operator==(const UserBsdfText&) const = default;
};

/// Everything that a trace kernel is composed of, and nothing more: what is false, zero or empty is
/// not in the kernel. Names are those of files in the folders of shaders/.
struct TraceKey {
  std::string integrator = "normals";  ///< or "centres", which writes layers of pixels' centres
  std::string userFile, userText;      ///< of an integrator of the user's own, used instead
  std::string camera = "perspective";
  std::string sampler = "independent";
  std::string background = "none";
  std::vector<std::string> bsdfs;  ///< those that surfaces have; none: the integrator needs none
  std::vector<UserBsdfText> userBsdfs;  ///< of these, those of the user's own
  std::vector<std::string> textures;    ///< those that surfaces show
  Traversal traversal = Traversal::Lane;
  std::uint32_t stack = 64;      ///< entries of the traversal's stack
  std::uint32_t jumpLevels = 0;  ///< tables that `independent` needs, 1 to 3
  bool hits = true;              ///< some hit or miss shows something; else no ray is traced
  bool normals = false;          ///< some mesh has vertex normals that show
  bool materials = false;        ///< the meshes differ in what they are made of
  bool bsdfRecords = false;      ///< a mesh's record says which BSDF it has, and its numbers
  bool spheres = false;          ///< some mesh is a sphere
  bool lights = false;           ///< point lights show
  bool manyLights = false;       ///< more than one dispatch sums
  bool byteImages = false, floatImages = false;  ///< what textures and the background are stored as
  bool adaptive = false;                         ///< cells have sample counts of their own
  bool signedValues = false;                     ///< negative values are not left out
  std::vector<KernelProperty> properties;        ///< of the integrator, in the order of its row

  bool operator==(const TraceKey&) const = default;
};

/// The same for the kernel that reconstructs.
struct GatherKey {
  std::string filter = "gaussian_narrow";
  std::uint32_t apron = 2;  ///< pixels on each side that a sample can reach
  bool strips = false;      ///< subgroups of 8 lanes share a strip (film/gather_strip.glsl)
  bool adaptive = false;

  bool operator==(const GatherKey&) const = default;
};

}  // namespace laver
