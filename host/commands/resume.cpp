#include "commands/resume.h"

#include <fmt/format.h>

#include <filesystem>
#include <sstream>

#include "commands/output.h"
#include "core/error.h"
#include "core/hash.h"
#include "image/io.h"

namespace laver {
namespace {

constexpr const char* kRows = "samplesByRow";  // rows x samples, from the top: 341x64 427x16
constexpr const char* kRowsWithoutSums = "rowsWithoutSums";
constexpr const char* kDropped = "samplesDropped";
constexpr const char* kHash = "hash";
const std::string kPrefix = "state.";

std::string rowsText(const FilmState& state) {
  std::string text;
  const int height = state.sums.height;
  for (int row = 0; row < height;) {
    const int rows = state.equalRows(row, height - row);
    text += fmt::format("{}{}x{}", row == 0 ? "" : " ", rows,
                        state.samples[static_cast<std::size_t>(row)]);
    row += rows;
  }
  return text;
}

/// The inverse of rowsText(); empty if the text does not list `height` rows.
std::vector<std::uint32_t> rowsOf(const std::string& text, int height) {
  std::vector<std::uint32_t> samples;
  std::istringstream in(text);
  std::uint32_t rows = 0, count = 0;
  char times = 0;
  const auto all = static_cast<std::size_t>(height);
  while (in >> rows >> times >> count && times == 'x' && rows <= all - samples.size())
    samples.insert(samples.end(), rows, count);
  return samples.size() == all && in.eof() ? samples : std::vector<std::uint32_t>{};
}

/// Everything except the sums. In the file these are string attributes with the prefix kPrefix.
std::map<std::string, std::string> texts(const FilmState& state) {
  std::map<std::string, std::string> all(state.settings.begin(), state.settings.end());
  all[kRows] = rowsText(state);
  all[kRowsWithoutSums] = std::to_string(state.finishedRows);
  all[kDropped] = std::to_string(state.dropped);
  return all;
}

/// Hash of the sums and of everything that describes them: EXR stores chunks that do not compress
/// without a checksum.
std::string hashOf(const FilmState& state) {
  Hash hash;
  for (const auto& [name, value] : texts(state)) {
    hash.add(name);
    hash.add(value);
  }
  hash.add(std::as_bytes(std::span(state.sums.pixels)));
  return hash.text();
}

}  // namespace

std::filesystem::path statePath(std::filesystem::path exr) {
  return exr.replace_extension(".state.exr");
}

FilmState readState(const std::filesystem::path& file) {
  FilmState state(FilmState::Keep::Always);
  state.file = file.string();
  state.sums = readExr(file.string());
  std::map<std::string, std::string> found;
  for (const auto& [name, value] : readExrTexts(file.string()))
    if (name.rfind(kPrefix, 0) == 0) found[name.substr(kPrefix.size())] = value;
  const auto take = [&](const char* name) {
    const auto node = found.extract(name);
    return node.empty() ? std::string() : node.mapped();
  };
  const std::string hash = take(kHash);
  state.samples = rowsOf(take(kRows), state.sums.height);
  std::istringstream(take(kRowsWithoutSums)) >> state.finishedRows;
  std::istringstream(take(kDropped)) >> state.dropped;
  state.settings.assign(found.begin(), found.end());
  if (state.samples.empty() || hashOf(state) != hash)
    throw Error(ExitCode::Usage, fmt::format("cannot resume from \"{}\": it is damaged, or not a "
                                             "file of sums",
                                             file.string()));
  return state;
}

void writeState(const std::filesystem::path& file, const FilmState& state, unsigned threads) {
  Metadata attributes;
  for (const auto& [name, value] : texts(state)) attributes[kPrefix + name] = value;
  attributes[kPrefix + kHash] = hashOf(state);
  writeExr(file.string(), state.sums, attributes, threads);
}

namespace {

/// Larger films, whose sums take over 2 GiB, are kept only with --resume.
constexpr std::int64_t kMaxPixelsKept = 1 << 26;

}  // namespace

FilmState stateOf(const RenderCommand& command, const std::filesystem::path& file,
                  const Camera& camera) {
  using Keep = FilmState::Keep;
  if (command.resume) {
    std::error_code ignored;
    const bool exists = std::filesystem::exists(file, ignored);
    print(command,
          exists ? fmt::format("Going on from \"{}\"\n", file.string())
                 : fmt::format("No \"{}\": rendering from the first sample\n", file.string()));
    return exists ? readState(file) : FilmState(Keep::Always);
  }
  const bool fits = std::int64_t{camera.width} * camera.height <= kMaxPixelsKept;
  return FilmState(!command.reference && fits ? Keep::WhenEnded : Keep::Nothing);
}

std::string leaveState(const RenderCommand& command, const std::filesystem::path& file,
                       const FilmState& state, bool continuable) {
  if (continuable && !state.empty()) {
    writeState(file, state, command.options.threads);
    return fmt::format("; --resume goes on from \"{}\"", file.string());
  }
  std::error_code ignored;
  if (command.resume) std::filesystem::remove(file, ignored);
  return {};
}

}  // namespace laver
