#pragma once
#include "scene/diagnostics.h"
#include "scene/schema.h"

namespace laver::xml {

/// Reads the images of a draft's textures and background, each once and several concurrently, if
/// the integrator uses them. A file that fails causes an error at the first object that names it.
void loadTextures(const TextSource& source, Draft& draft, Diagnostics& diagnostics);

/// Warns of meshes that have a texture but no texture coordinates.
void warnOfMissingUvs(const Draft& draft, Diagnostics& diagnostics);

}  // namespace laver::xml
