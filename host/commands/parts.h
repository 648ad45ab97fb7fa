#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "commands/commands.h"
#include "image/io.h"
#include "render/film_state.h"
#include "render/rendered.h"
#include "render/strips.h"

// Parts of a picture: `laver SCENE --shard I/N` renders one, `laver merge` joins them. The file of
// a part has the rows of its strips one below the other, and says in string attributes which part
// of which render it is.
namespace laver {

/// The settings of a part that the reference renders, which come from the Vulkan renderer
/// otherwise. Throws Error(Usage) if a file of the scene cannot be read a second time.
Settings settingsOfReference(const RenderCommand& command, const Scene& scene);

/// Writes a part, whole or not. Throws Error(Output).
void writePart(const std::filesystem::path& exr, const RenderCommand& command, const Scene& scene,
               const Rendered& rendered, const Settings& settings, Metadata metadata);

/// Rows [first, end) of the film.
struct RowRange {
  int first, end;
};

/// What the file of a part says about it.
struct Part {
  std::string file;
  Shard shard;
  std::vector<RowRange> rows;
  std::map<std::string, std::string> settings;  ///< equal in all parts of a picture
  std::string unfinished;  ///< how far an interrupted part got; empty: it is whole
};

/// Reads the attributes of a part. Throws Error(Usage) if the file is none.
Part readPart(const std::string& file);

/// Reads the pixels of a part. Throws Error(Usage) if the file is damaged.
Image readPixels(const Part& part);

/// Whether an attribute describes a part, and not the picture.
bool isOfPart(const std::string& attribute);

}  // namespace laver
