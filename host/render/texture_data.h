#pragma once
#include <map>

#include "render/scene_data.h"

namespace laver {

/// Packs what textures and the background need, each picture once.
class TexturePacker {
 public:
  explicit TexturePacker(SceneData& data) : data_(data) {}

  /// Adds a material's record. Its mesh's first triangle has the number `firstId`.
  void addMaterial(const Mesh& mesh, std::uint32_t firstId);

  /// Adds the texture coordinates of the next triangle of that mesh, if it shows a texture: for the
  /// corners of `stored`, which are those of `given` in another order.
  void addTriangle(const Mesh& mesh, glm::uvec3 given, glm::uvec3 stored);

  /// Fills the background's part of data.params.
  void packBackground(const Environment& environment);

 private:
  shared::Picture add(const Picture& picture, bool raw);
  std::uint32_t tableOf(bool raw);

  SceneData& data_;
  std::map<const Picture*, std::uint32_t> pictures_;  ///< first word
  std::map<bool, std::uint32_t> tables_;              ///< by `raw`
};

/// SPEC_TEXTURES, SPEC_IMAGES and SPEC_BACKGROUND of a scene. Textures count where light falls.
void specialiseTextures(const Scene& scene, const IntegratorRow& shown, SpecConstants& constants);

}  // namespace laver
