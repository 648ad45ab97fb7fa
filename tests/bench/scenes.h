#pragma once
#include <string>

#include "scene/scene.h"

namespace laver::bench {

/// A scene of tests/bench/scenes/ without vertex normals, its meshes subdivided `times` times.
/// Throws Error.
Scene benchScene(const std::string& name, int times = 0);

/// Scene files of scenes/ and of this folder.
std::string sceneFile(const std::string& path);

}  // namespace laver::bench
