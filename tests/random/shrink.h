#pragma once
#include <functional>
#include <string>

#include "random/generator.h"

namespace laver::test {

/// Leaves out meshes, triangles, lights and features one at a time as long as `fails` is true of
/// what remains.
RandomScene shrunk(RandomScene random, const std::function<bool(const RandomScene&)>& fails);

/// Writes scene.xml and its OBJ files to a folder, which must exist. The numbers are exact, so that
/// laver reads the same scene.
void writeScene(const Scene& scene, const std::string& folder);

}  // namespace laver::test
