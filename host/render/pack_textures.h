#pragma once
#include <map>

#include "render/packed.h"

namespace laver {

/// Packs the data of textures and the background, each image once.
class TexturePacker {
 public:
  explicit TexturePacker(Packed& packed, const std::vector<std::string>& kinds)
      : packed_(packed), kinds_(kinds) {}

  /// The records and triangles that follow are those of a mesh, whose first triangle has the number
  /// `firstId`.
  void beginMesh(const Mesh& mesh, std::uint32_t firstId);

  /// shared::Texture::uvs of the mesh.
  std::uint32_t uvs() const { return uvs_; }

  /// Adds the record of a texture; returns its place.
  std::uint32_t addRecord(const Texture& texture);

  /// Adds the texture coordinates of the next triangle, if its mesh shows a texture: for the
  /// corners of `stored`, which are those of `given` in another order.
  void addTriangle(const Mesh& mesh, glm::uvec3 given, glm::uvec3 stored);

  /// The same of a piece of a mesh that was split. Of textures that repeat, whole periods are left
  /// out of its coordinates, in double precision.
  void addPiece(const Mesh& mesh, const Piece& piece, glm::uvec3 stored);

  /// Fills the background's part of packed.params.
  void packBackground(const Environment& environment);

 private:
  /// `red`: the red channel for all three.
  shared::ImageRef add(const Picture& picture, bool raw, bool red);
  std::uint32_t tableOf(bool raw);

  Packed& packed_;
  const std::vector<std::string>& kinds_;
  std::map<std::pair<const Picture*, bool>, std::uint32_t> pictures_;  ///< first word
  std::map<bool, std::uint32_t> tables_;                               ///< by `raw`
  bool textured_ = false;                                              ///< the mesh
  std::uint32_t uvs_ = 0;  ///< of the mesh: shared::Texture::uvs
};

}  // namespace laver
