#pragma once
#include <filesystem>
#include <string>

#include "commands/commands.h"
#include "render/film_state.h"

namespace laver {

/// The file of sums for a picture: a.state.exr for a.exr.
std::filesystem::path statePath(std::filesystem::path exr);

/// Reads a file of sums. Throws Error(Usage) if it is damaged or no such file.
FilmState readState(const std::filesystem::path& file);

/// Writes a file of sums, replacing the file. Throws Error(Output).
void writeState(const std::filesystem::path& file, const FilmState& state, unsigned threads);

/// The state to start a render from: sums of an earlier one, or empty, with the rule for keeping
/// sums.
FilmState stateOf(const RenderCommand& command, const std::filesystem::path& file,
                  const Camera& camera);

/// Writes the sums if a later render can continue from them; otherwise, with --resume, removes the
/// file. Returns a text about the sums.
std::string leaveState(const RenderCommand& command, const std::filesystem::path& file,
                       const FilmState& state, bool continuable);

}  // namespace laver
