#pragma once
#include <filesystem>

#include "commands/commands.h"

// What can be checked before a long render, so that nothing is rendered for nothing.
namespace laver {

/// Throws Error(Usage) for options that do not go together, Error(Device) for a film too large for
/// the machine's memory.
void checkRender(const RenderCommand& command, const Camera& camera);

/// Says so on standard error where a layer of texture coordinates is asked for and a mesh has none.
void warnOfMissingUvs(const RenderOptions& options, const Scene& scene);

/// The picture's file, which can be written, as can the PNG beside it. Throws Error(Usage) or
/// Error(Output).
std::filesystem::path outputOf(const RenderCommand& command);

}  // namespace laver
