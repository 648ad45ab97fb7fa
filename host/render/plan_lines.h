#pragma once
#include <string>
#include <vector>

#include "render/scene_plan.h"

namespace laver {

/// What the lines of a plan are made of.
struct Facts {
  const Scene& scene;
  const SceneData& data;
  std::uint32_t likelyStack;  ///< of the kernel that is compiled before there is a tree
  bool shaded = false;        ///< some picture shows direct_whitted
  bool coloured = false;      ///< some picture shows what colour the meshes have
  std::size_t pictures = 1;   ///< that are reconstructed
  std::uint64_t triangles = 0, normals = 0, uvs = 0;  ///< of all meshes; triangles: spheres too
  std::uint64_t spheres = 0;

  std::uint32_t constant(std::uint32_t c) const { return data.constants[c]; }
  /// Of the records that materials would take. With textures they are there in any case.
  std::uint64_t materialBytes() const {
    return constant(shared::SPEC_TEXTURES) != 0 ? 0
                                                : scene.meshes.size() * sizeof(shared::Material);
  }
  bool traced() const { return constant(shared::SPEC_HITS) != 0; }
};

/// "1 node", "2 nodes".
std::string countOf(std::uint64_t n, const char* one, const char* more = nullptr);

/// What of the scene is uploaded and looked at, and why.
std::vector<ScenePlan::Line> sceneLines(const Facts& facts);

}  // namespace laver
