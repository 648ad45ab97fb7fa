#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "commands/commands.h"
#include "image/io.h"
#include "render/rendered.h"
#include "render/stats.h"

// Files that a render writes: the picture as OpenEXR and PNG, and statistics. (resume.h: its sums.)
namespace laver {

/// Prints to standard output, unless the command is quiet.
void print(const RenderCommand& command, const std::string& text);

/// The picture's file, after checking that it, the PNG and with --resume the file of sums can be
/// written, and that the picture replaces no file of the scene. Throws Error(Usage) or
/// Error(Output).
std::filesystem::path outputOf(const RenderCommand& command, const Scene& scene);

/// The files that a scene was read from, itself first.
std::vector<std::filesystem::path> filesOf(const Scene& scene);

/// A name that -o gives, after checking that the picture and its PNG can be written. Throws
/// Error(Usage) or Error(Output).
std::filesystem::path pictureFile(const std::filesystem::path& exr);

/// The attributes of a picture's EXR file. For an incomplete picture they include how many samples
/// per pixel were requested, and how many rows hold some and all of them.
Metadata metadataOf(const Scene& scene, const Rendered& rendered, const Stats& stats,
                    double renderSeconds);

/// Writes the picture as EXR and PNG concurrently. Throws Error(Output).
void writePictures(const std::filesystem::path& exr, const Image& image, const Metadata& metadata,
                   unsigned threads);

/// Writes the statistics for --stats to standard error or a file. Throws Error(Output).
void writeStats(const RenderCommand& command, const Stats& stats);

}  // namespace laver
