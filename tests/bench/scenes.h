#pragma once
#include <string>

#include "scene/scene.h"

namespace laver::bench {

/// A scene of tests/bench/scenes/ without vertex normals, its meshes subdivided `times` times.
/// Throws Error.
Scene benchScene(const std::string& name, int times, const std::string& integrator,
                 std::uint32_t samples);

/// "bunny", or "bunny x16" where each triangle is split into 16.
std::string titleOf(const std::string& scene, int times);

/// "1 sample", "16 samples".
std::string counted(std::size_t count, const std::string& thing);

/// A file of the source tree.
std::string sceneFile(const std::string& path);

}  // namespace laver::bench
