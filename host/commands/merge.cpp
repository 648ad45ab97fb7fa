#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "commands/commands.h"
#include "commands/output.h"
#include "commands/parts.h"
#include "core/atomic_file.h"

namespace laver {
namespace {

[[noreturn]] void refuse(const std::string& reason) {
  throw Error(ExitCode::Usage, "cannot merge: " + reason);
}

/// Refuses two parts that are not of the same render. A scene's content includes other settings, so
/// it is compared last.
void checkAlike(const Part& first, const Part& part) {
  if (part.shard.count != first.shard.count)
    refuse(fmt::format("\"{}\" is part {}, \"{}\" is part {}", part.file, textOf(part.shard),
                       first.file, textOf(first.shard)));
  auto settings = first.settings;
  settings.insert(part.settings.begin(), part.settings.end());
  const auto of = [](const Part& one, const std::string& name) {
    const auto found = one.settings.find(name);
    return found == one.settings.end() ? std::string("none") : found->second;
  };
  for (const auto& [name, value] : settings)
    if (name != "scene" && of(part, name) != of(first, name))
      refuse(fmt::format("{} of \"{}\" is {}, of \"{}\" {}", name, part.file, of(part, name),
                         first.file, of(first, name)));
  if (of(part, "scene") != of(first, "scene"))
    refuse(fmt::format("the scenes of \"{}\" and \"{}\" differ", part.file, first.file));
}

/// Refuses parts that are not all parts of one picture, each once.
void checkComplete(const std::vector<Part>& parts) {
  const int count = parts.front().shard.count;
  std::vector<const Part*> byIndex(static_cast<std::size_t>(count), nullptr);
  for (const Part& part : parts) {
    checkAlike(parts.front(), part);
    if (!part.unfinished.empty())
      refuse(fmt::format("part {}, \"{}\", was interrupted: {}", textOf(part.shard), part.file,
                         part.unfinished));
    const Part*& place = byIndex[static_cast<std::size_t>(part.shard.index)];
    if (place != nullptr)
      refuse(fmt::format("part {} is there twice, \"{}\" and \"{}\"", textOf(part.shard),
                         place->file, part.file));
    place = &part;
  }
  std::string missing;
  for (int i = 0; i < count; ++i)
    if (byIndex[static_cast<std::size_t>(i)] == nullptr)
      missing += (missing.empty() ? "" : ", ") + textOf({i, count});
  if (missing.empty()) return;
  const bool several = missing.find(',') != std::string::npos;
  refuse(fmt::format("part{} {} {} missing", several ? "s" : "", missing, several ? "are" : "is"));
}

/// The film and the crop that a part's settings name.
struct Place {
  Crop core{};
  FilmWindow window{};
};

Place placeOf(const Part& part) {
  Place place;
  auto& [x0, y0, x1, y1] = place.core;
  FilmWindow& w = place.window;
  const auto text = [&](const char* name) {
    const auto found = part.settings.find(name);
    return found == part.settings.end() ? std::string() : found->second;
  };
  if (std::sscanf(text("crop").c_str(), "%d,%d,%d,%d", &x0, &y0, &x1, &y1) != 4 ||
      std::sscanf(text("film").c_str(), "%dx%d", &w.filmWidth, &w.filmHeight) != 2 || x0 < 0 ||
      y0 < 0 || x0 >= x1 || y0 >= y1 || x1 > w.filmWidth || y1 > w.filmHeight)
    refuse(fmt::format("\"{}\" is damaged", part.file));
  w.x = x0;
  w.y = y0;
  return place;
}

/// Copies the rows of a part into the picture of `place`; counts them in `filled`.
void put(const Part& part, const Place& place, Image& picture, std::vector<bool>& filled) {
  const Image image = readPixels(part);
  if (picture.channels.empty())
    picture =
        blackImage(place.core.x1 - place.core.x0, place.core.y1 - place.core.y0, image.channels);
  if (image.width != picture.width || image.channels != picture.channels)
    refuse(fmt::format("\"{}\" is damaged", part.file));
  const std::size_t stride = static_cast<std::size_t>(image.width) * image.channels.size();
  const float* from = image.pixels.data();
  for (const auto& [first, end] : part.rows)
    for (int y = first; y < end; ++y, from += stride) {
      if (y < place.core.y0 || y >= place.core.y1 ||
          filled[static_cast<std::size_t>(y - place.core.y0)])
        refuse(fmt::format("row {} of \"{}\" is in another part, or outside of the picture", y,
                           part.file));
      filled[static_cast<std::size_t>(y - place.core.y0)] = true;
      std::copy_n(from, stride, &picture.at(0, y - place.core.y0, 0));
    }
}

/// The attributes of the whole picture: those of the first part, times added, samples averaged.
Metadata metadataOf(const std::vector<Part>& parts, int rows) {
  Metadata metadata;
  double seconds = 0, samples = 0;
  for (const Part& part : parts) {
    const Metadata of = readExrMetadata(part.file);
    if (&part == &parts.front()) metadata = of;
    const auto number = [&](const char* name) {
      const auto found = of.find(name);
      const double* value = found == of.end() ? nullptr : std::get_if<double>(&found->second);
      return value == nullptr ? 0.0 : *value;
    };
    seconds += number("renderTimeSeconds");
    for (const RowRange& range : part.rows)
      samples += number("samplesPerPixelAverage") * (range.end - range.first);
  }
  std::erase_if(metadata, [](const auto& attribute) { return isOfPart(attribute.first); });
  metadata["renderTimeSeconds"] = seconds;
  if (samples > 0) metadata["samplesPerPixelAverage"] = samples / rows;
  return metadata;
}

}  // namespace

ExitCode run(const MergeCommand& command) {
  std::vector<Part> parts;
  for (const std::string& file : command.parts) parts.push_back(readPart(file));
  const std::filesystem::path exr = pictureFile(command.output);
  for (const Part& part : parts) {
    std::error_code error;
    if (std::filesystem::equivalent(part.file, exr, error))
      throw Error(ExitCode::Usage, fmt::format("-o {}: that is one of the parts", exr.string()));
  }
  const Place place = placeOf(parts.front());
  if (parts.front().shard.count > place.core.y1 - place.core.y0)
    refuse(fmt::format("\"{}\" is damaged", parts.front().file));
  checkComplete(parts);
  Image picture;
  std::vector<bool> filled(static_cast<std::size_t>(place.core.y1 - place.core.y0));
  for (const Part& part : parts) put(part, place, picture, filled);
  const auto gap = std::find(filled.begin(), filled.end(), false);
  if (gap != filled.end())
    refuse(fmt::format("row {} is in no part", place.core.y0 + (gap - filled.begin())));
  picture.window = place.window;
  writePictures(exr, picture, metadataOf(parts, picture.height), 0);
  return ExitCode::Ok;
}

}  // namespace laver
