#pragma once
#include <map>

#include "render/packed.h"

namespace laver {

/// Packs the data of textures and the background, each image once.
class TexturePacker {
 public:
  explicit TexturePacker(Packed& packed, const std::vector<std::string>& kinds)
      : packed_(packed), kinds_(kinds) {}

  /// Adds the texture record of a mesh whose first triangle has the number `firstId`.
  void addRecord(const Mesh& mesh, std::uint32_t firstId);

  /// Adds the texture coordinates of the mesh's next triangle, if it has a texture. `stored` is a
  /// permutation of the corners `given` in the file.
  void addTriangle(const Mesh& mesh, glm::uvec3 given, glm::uvec3 stored);

  /// Fills the background's part of packed.params.
  void packBackground(const Environment& environment);

 private:
  shared::ImageRef add(const Picture& picture, bool raw);
  std::uint32_t tableOf(bool raw);

  std::uint32_t kindOf(const std::optional<Texture>& texture) const;

  Packed& packed_;
  const std::vector<std::string>& kinds_;
  std::map<const Picture*, std::uint32_t> pictures_;  ///< first word
  std::map<bool, std::uint32_t> tables_;              ///< by `raw`
};

}  // namespace laver
