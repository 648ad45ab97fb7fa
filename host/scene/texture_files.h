#pragma once
#include "scene/diagnostics.h"
#include "scene/schema.h"

namespace laver::xml {

/// Reads the pictures of a draft's textures and background, each once and several at a time, if the
/// integrator shows them. One that fails leaves an error where the first to name it stands.
void loadTextures(const TextSource& source, Draft& draft, Diagnostics& diagnostics);

/// Warns of meshes of the scene that show a texture and have no texture coordinates.
void warnOfMissingUvs(const Draft& draft, Diagnostics& diagnostics);

}  // namespace laver::xml
