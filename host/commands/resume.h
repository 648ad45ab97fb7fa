#pragma once
#include <filesystem>
#include <string>

#include "commands/commands.h"
#include "render/film_state.h"

namespace laver {

/// Where the sums of a picture lie: a.state.exr beside a.exr.
std::filesystem::path statePath(std::filesystem::path exr);

/// Reads them, to keep them always. Throws Error(Usage) for a file that is not whole.
FilmState readState(const std::filesystem::path& file);

/// Writes them, replacing the file. Throws Error(Output).
void writeState(const std::filesystem::path& file, const FilmState& state, unsigned threads);

/// What there is to go on from, or what an ended render will leave.
FilmState stateOf(const RenderCommand& command, const std::filesystem::path& file,
                  const Camera& camera);

/// Writes the sums where a render can go on from them, and removes them where it cannot. Returns
/// what to say about them.
std::string leaveState(const RenderCommand& command, const std::filesystem::path& file,
                       const FilmState& state, bool more);

}  // namespace laver
