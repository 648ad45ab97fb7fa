#pragma once
#include <string>

#include "scene/diagnostics.h"
#include "scene/schema.h"

namespace laver::xml {

/// The path of a file that a scene names: next to the scene file, in the working directory, or the
/// name itself. Empty if there is none.
std::string findFile(const std::string& sceneFile, const std::string& name);

/// Reads the mesh files of a draft, each once and several concurrently, and moves the meshes into
/// the scene. A mesh that fails causes errors.
void loadMeshes(const TextSource& source, Draft& draft, Diagnostics& diagnostics);

}  // namespace laver::xml
