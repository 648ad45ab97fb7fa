#pragma once
#include <filesystem>
#include <string>

#include "commands/commands.h"
#include "image/io.h"
#include "render/rendered.h"
#include "render/stats.h"

// What a render writes: the picture as OpenEXR and PNG, and its figures. (resume.h: its sums.)
namespace laver {

/// Prints to standard output, unless --quiet forbids it.
void print(const RenderCommand& command, const std::string& text);

/// The picture's file, which can be written, as can those beside it: the PNG, and with --resume the
/// sums. Throws Error(Usage) or
/// Error(Output).
std::filesystem::path outputOf(const RenderCommand& command);

/// The attributes of a picture's EXR file. Of a picture that is not whole they also say how many
/// samples a pixel were wanted and how many rows hold some and all of them.
Metadata metadataOf(const Scene& scene, const Rendered& rendered, const Stats& stats,
                    double renderSeconds);

/// Writes the picture and the PNG beside it, side by side. Throws Error(Output).
void writePictures(const std::filesystem::path& exr, const Image& image, const Metadata& metadata,
                   unsigned threads);

/// Writes what --stats asks for, to standard error or a file. Throws Error(Output).
void writeStats(const RenderCommand& command, const Stats& stats);

}  // namespace laver
