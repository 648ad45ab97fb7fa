#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "bvh/bvh.h"
#include "render/specialise.h"

namespace laver {

/// Space of the kernels: p' = scale * (p - centre), so that all vertices lie in [-1, 1]^3. The
/// scale is a power of two; without meshes the space is the scene's own.
struct Normalisation {
  glm::dvec3 centre{0.0};
  double scale = 1.0;
  glm::dvec3 apply(glm::dvec3 p) const { return (p - centre) * scale; }
};
Normalisation normalisationOf(const Scene& scene);

/// A scene in the layout of the kernels; empty arrays are not uploaded.
struct SceneData {
  Normalisation space;
  Bvh bvh;
  std::vector<shared::Attributes> attributes;  ///< one a triangle, in the order of the leaves
  std::vector<glm::vec4> normals;
  std::vector<shared::Material> materials;
  std::vector<shared::Light> lights;
  std::vector<shared::Jump> jumps;
  std::vector<shared::Texture> textures;  ///< one a material, instead of `materials`
  std::vector<glm::vec2> uvs;             ///< three a triangle that shows a texture
  std::vector<std::uint32_t> images;      ///< all pictures and their tables
  shared::Params params{};
  SpecConstants constants{};
  std::uint64_t triangles = 0;           ///< uploaded
  std::uint64_t collapsedTriangles = 0;  ///< two corners fell together when rounded to float
  double buildSeconds = 0;               ///< of the tree
};

/// Rounds, builds and packs what kernels with these constants read; makes the stack deep enough.
SceneData packScene(const Scene& scene, const RenderOptions& options,
                    const SpecConstants& constants);

}  // namespace laver
