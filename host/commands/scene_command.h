#pragma once
#include <string>

#include "commands/commands.h"

// The scenes of commands: loaded, with warnings on standard error, and checked before a long
// render, so that nothing is rendered for nothing.
namespace laver {

/// Prints the warnings. Throws Error(Scene).
Scene sceneOf(const std::string& file, const SceneOverrides& overrides = {});

/// The same, with what the command changes. Throws Error(Usage) where a scene cannot be rendered
/// with such options.
Scene sceneOf(const SceneCommand& command);

/// Throws Error(Usage) for options that do not go together, Error(Device) for a film too large for
/// the machine's memory. Warns where a layer of texture coordinates is asked for and a mesh has
/// none.
void checkRender(const RenderCommand& command, const Scene& scene);

}  // namespace laver
