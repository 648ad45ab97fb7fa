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
  std::uint64_t triangles = 0, normals = 0, uvs = 0;  ///< of all meshes

  std::uint32_t constant(std::uint32_t c) const { return data.constants[c]; }
  bool shaded() const { return scene.integrator == Integrator::DirectWhitted; }
  bool traced() const { return constant(shared::SPEC_HITS) != 0; }
};

/// "1 node", "2 nodes".
std::string countOf(std::uint64_t n, const char* what);

/// What of the scene is uploaded and looked at, and why.
std::vector<ScenePlan::Line> sceneLines(const Facts& facts);

}  // namespace laver
