#pragma once
#include <string>

#include "scene/diagnostics.h"
#include "scene/schema.h"

namespace laver::xml {

/// Where a file of a scene lies: beside the scene file, then in the working directory, then as
/// written. Empty if it is nowhere.
std::string findFile(const std::string& sceneFile, const std::string& name);

/// Reads the mesh files of a draft, each once and several at a time, and moves the meshes into the
/// scene. A mesh that fails leaves errors.
void loadMeshes(const TextSource& source, Draft& draft, Diagnostics& diagnostics);

}  // namespace laver::xml
