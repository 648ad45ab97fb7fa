#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace laver::test {

/// What determines the kernels of a random scene. Kinds are few, since compiling costs more than
/// rendering: kBlock consecutive seeds share one, and kKinds of them follow each other in a cycle.
struct Kind {
  std::uint64_t number;
  const IntegratorRow* integrator;
  const SamplerRow* sampler;
  Filter filter;
  std::vector<const BsdfRow*> bsdfs;  ///< of the first meshes, one each
  const TextureRow* texture;          ///< of the first mesh; null: none
  const EmitterRow* sky;              ///< null: black
  bool lamp;                          ///< the second mesh emits, if the integrator shows it
  const TextureRow* shown = nullptr;  ///< by that mesh; null: one colour
  const TextureRow* bends = nullptr;  ///< the normals of the first meshes; null: nothing
  bool anisotropic = false;           ///< BSDFs that can be
  bool lens;
  bool general;                         ///< one kernel for all scenes: no part is left out
  std::vector<std::string> traversals;  ///< by which it is rendered

  /// Differences from the reference are explained one by one (host/lab/explain/).
  bool explained() const { return !integrator->bounces && !lens; }
};

inline constexpr std::uint64_t kBlock = 50, kKinds = 96;

Kind kindOf(std::uint64_t seed);

/// The seeds of [from, to) in an order in which those of one kind follow each other.
std::vector<std::uint64_t> seedsByKind(std::uint64_t from, std::uint64_t to);

}  // namespace laver::test
