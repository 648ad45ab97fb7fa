#pragma once
#include <filesystem>

#include "render/film_state.h"

namespace laver {

/// Where the sums of a picture lie: a.state.exr beside a.exr.
std::filesystem::path statePath(std::filesystem::path exr);

/// Reads them, to keep them always. Throws Error(Usage) for a file that is not whole.
FilmState readState(const std::filesystem::path& file);

/// Writes them, replacing the file. Throws Error(Output).
void writeState(const std::filesystem::path& file, const FilmState& state, unsigned threads);

}  // namespace laver
