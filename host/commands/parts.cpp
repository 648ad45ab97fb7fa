#include "commands/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <sstream>

#include "commands/output.h"
#include "core/hash.h"
#include "scene/dialects.h"

namespace laver {
namespace {

const std::string kShard = "shard";
const std::string kRows = "shard.rows";  // for example 0-44 360-404
const std::string kUnfinished = "shard.unfinished";
const std::string kHash = "shard.hash";
const std::string kSetting = "shard.settings.";

using Texts = std::map<std::string, std::string>;

std::string rowsText(const std::vector<Strip>& strips) {
  std::string text;
  for (const Strip& strip : strips)
    text += fmt::format("{}{}-{}", text.empty() ? "" : " ", strip.pixels.y0, strip.pixels.y1 - 1);
  return text;
}

/// The inverse of rowsText(); empty if the text is malformed.
std::vector<RowRange> rowsOf(const std::string& text) {
  std::vector<RowRange> rows;
  std::istringstream in(text);
  int first = 0, last = 0;
  char dash = 0;
  while (in >> first >> dash >> last && dash == '-' && first <= last)
    rows.push_back({first, last + 1});
  return in.eof() ? rows : std::vector<RowRange>{};
}

/// Hash of the attributes and, channel by channel in the order of their names, of the pixels. EXR
/// chunks that do not compress are stored without a checksum.
std::string hashOf(const Texts& texts, const Image& image) {
  Hash hash;
  for (const auto& [name, value] : texts) {
    hash.add(name);
    hash.add(value);
  }
  std::vector<std::size_t> order(image.channels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return image.channels[a] < image.channels[b]; });
  std::vector<float> plane(image.pixels.size() / image.channels.size());
  for (const std::size_t channel : order) {
    for (std::size_t i = 0; i < plane.size(); ++i)
      plane[i] = image.pixels[i * order.size() + channel];
    hash.add(image.channels[channel]);
    hash.add(std::as_bytes(std::span(plane)));
  }
  return hash.text();
}

/// Further integrators, with a hash of a user's own text.
std::string namesOf(const std::vector<IntegratorUse>& more) {
  std::string names;
  for (const IntegratorUse& use : more) {
    names += fmt::format("{}{}", names.empty() ? "" : ",", use.row->name);
    if (!use.user) continue;
    Hash hash;
    hash.add(use.user->text);
    names += fmt::format(" {}", hash.text());
  }
  return names.empty() ? "none" : names;
}

std::string joinedNames(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

/// The attributes of a file that describe it as a part, but for the hash.
Texts textsOf(const std::string& file) {
  Texts texts;
  for (const auto& [name, value] : readExrTexts(file))
    if (isOfPart(name) && name != kHash) texts[name] = value;
  return texts;
}

}  // namespace

bool isOfPart(const std::string& attribute) {
  return attribute == kShard || attribute.starts_with(kShard + '.');
}

Settings settingsOfReference(const RenderCommand& command, const Scene& scene) {
  const Dialect* dialect = command.overrides.dialect;
  Hash content;
  content.add(describe(scene));
  content.add(dialect == nullptr ? "" : std::string(dialect->name));
  for (const std::filesystem::path& file : filesOf(scene)) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) continue;  // the name of a sphere
    const auto hash =
        std::filesystem::is_regular_file(file, error) ? hashOfFile(file.string()) : std::nullopt;
    if (!hash)
      throw Error(ExitCode::Usage, fmt::format("--shard with --reference: \"{}\" cannot be read a "
                                               "second time",
                                               file.string()));
    content.add(*hash);
  }
  Settings settings =
      settingsOf(scene, coreOf(scene.camera, command.options), command.options.noriCompat);
  settings.emplace_back("device", "reference");
  settings.emplace_back("scene", content.text());
  return settings;
}

void writePart(const std::filesystem::path& exr, const RenderCommand& command, const Scene& scene,
               const Rendered& rendered, const Settings& settings, Metadata metadata) {
  const RenderOptions& options = command.options;
  Texts texts;
  for (const auto& [name, value] : settings)
    if (name != kShard) texts[kSetting + name] = value;
  texts[kSetting + "sampleCount"] = std::to_string(scene.sampler.sampleCount);
  texts[kSetting + "error"] = fmt::format("{}", options.error);
  texts[kSetting + "channels"] = joinedNames(rendered.image.channels);
  texts[kSetting + "furtherIntegrators"] = namesOf(options.more);
  texts[kShard] = textOf(*options.shard);
  texts[kRows] = rowsText(stripsOf(scene, options));
  if (!rendered.whole())
    texts[kUnfinished] = fmt::format("{} of {} rows are finished", rendered.reached.wholeRows,
                                     rendered.image.height);
  metadata.insert(texts.begin(), texts.end());
  metadata[kHash] = hashOf(texts, rendered.image);
  writeExr(exr.string(), rendered.image, metadata, options.threads);
}

Part readPart(const std::string& file) {
  Part part;
  part.file = file;
  const Texts texts = textsOf(file);
  for (const auto& [name, value] : texts)
    if (name.starts_with(kSetting)) part.settings[name.substr(kSetting.size())] = value;
  const auto textOf = [&](const std::string& name) {
    const auto found = texts.find(name);
    return found == texts.end() ? std::string() : found->second;
  };
  char slash = 0;
  std::istringstream(textOf(kShard)) >> part.shard.index >> slash >> part.shard.count;
  part.rows = rowsOf(textOf(kRows));
  part.unfinished = textOf(kUnfinished);
  if (slash != '/' || part.shard.index < 0 || part.shard.index >= part.shard.count ||
      part.rows.empty())
    throw Error(ExitCode::Usage,
                fmt::format("\"{}\" is no part of a picture: --shard writes them", file));
  return part;
}

Image readPixels(const Part& part) {
  Image image = readExr(part.file);
  int rows = 0;
  for (const RowRange& range : part.rows) rows += range.end - range.first;
  const auto all = readExrTexts(part.file);
  const auto hash = all.find(kHash);
  if (image.height != rows || hash == all.end() ||
      hashOf(textsOf(part.file), image) != hash->second)
    throw Error(ExitCode::Usage, fmt::format("cannot merge \"{}\": it is damaged", part.file));
  return image;
}

}  // namespace laver
