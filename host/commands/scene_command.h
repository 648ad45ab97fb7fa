#pragma once
#include <string>

#include "commands/commands.h"

// Loads the scenes of commands, prints warnings to standard error, and checks options before a long
// render.
namespace laver {

/// Loads a scene and prints its warnings. Throws Error(Scene).
Scene sceneOf(const std::string& file, const SceneOverrides& overrides = {});

/// Loads a command's scene with its overrides. Throws Error(Usage) if the scene cannot be rendered
/// with these options.
Scene sceneOf(const SceneCommand& command);

/// Throws Error(Usage) for options that exclude each other, Error(Device) if the film is too large
/// for the machine's memory. Warns if the layer of texture coordinates is requested and a mesh has
/// none.
void checkRender(const RenderCommand& command, const Scene& scene);

}  // namespace laver
