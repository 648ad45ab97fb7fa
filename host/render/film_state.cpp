#include "render/film_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "core/error.h"
#include "vulkan/device_info.h"

namespace laver {
namespace {

constexpr std::size_t kFloats = sizeof(shared::FilmPixel) / sizeof(float);

}  // namespace

Settings settingsOf(const Scene& scene, const Crop& core, bool noriTable) {
  return {{"laverVersion", LAVER_VERSION},
          {"integrator", scene.integrator.row->name},
          {"film", fmt::format("{}x{}", scene.camera.width, scene.camera.height)},
          {"crop", fmt::format("{},{},{},{}", core.x0, core.y0, core.x1, core.y1)},
          {"sampler", scene.sampler.row->name},
          {"seed", std::to_string(scene.sampler.seed)},
          {"filterWeights", noriTable ? "Nori's table" : "exact"}};
}

Settings settingsOf(const Scene& scene, const Packed& packed, const Choices& choices,
                    const DeviceInfo& device) {
  Settings settings = settingsOf(scene, choices.core, choices.uploads.noriTable);
  settings.insert(settings.begin() + 1, {{"device", device.name}, {"driver", device.driver}});
  settings.emplace_back("samplesSummedPlainly", std::to_string(shared::GATHER_SAMPLES));
  if (!scene.sampler.row->countFree)
    settings.emplace_back("sampleCount", std::to_string(scene.sampler.sampleCount));
  settings.emplace_back("scene", contentOf(packed, choices));
  return settings;
}

void FilmState::begin(const Settings& now, int width, int height, std::uint32_t wanted) {
  if (empty()) {
    settings = now;
    samples.assign(static_cast<std::size_t>(height), 0);
    return;
  }
  for (const auto& [name, value] : now) {
    // Copied to a plain variable: clang 14 cannot capture structured bindings.
    const auto same = [&name = name](const auto& setting) { return setting.first == name; };
    const auto found = std::find_if(settings.begin(), settings.end(), same);
    const std::string had = found == settings.end() ? "none" : found->second;
    if (had == value) continue;
    if (name == "sampleCount")
      refuse(
          fmt::format("started with {} samples per pixel, {} are requested: this sampler's samples "
                      "depend on their count, those of sobol do not",
                      had, value));
    if (name == "scene") refuse("the scene or a file that it names has changed");
    refuse(fmt::format("{} was {}, now it is {}", name, had, value));
  }
  if (sums.width != width || sums.height != height || samples.size() != std::size_t(height))
    refuse(fmt::format("its size is not {}x{} pixels", width, height));
  if (samples[0] > wanted)
    refuse(fmt::format("it holds {} samples per pixel, {} are requested", samples[0], wanted));
  if (finishedRows != 0 && samples[0] != wanted)
    refuse(
        fmt::format("it was started without --resume: {} of its rows hold {} samples per pixel and "
                    "cannot be continued to {}",
                    finishedRows, samples[0], wanted));
}

int FilmState::equalRows(int row, int limit) const {
  const auto first = samples.begin() + row;
  return static_cast<int>(
      std::find_if(first, first + limit, [&](std::uint32_t n) { return n != *first; }) - first);
}

std::span<const std::byte> FilmState::bytes(int row, int rows) const {
  const std::size_t floats = static_cast<std::size_t>(sums.width) * kFloats;
  return std::as_bytes(std::span(sums.pixels)
                           .subspan(static_cast<std::size_t>(row) * floats,
                                    static_cast<std::size_t>(rows) * floats));
}

void FilmState::take(int row, int rows, std::span<const std::byte> film, std::uint32_t count) {
  allocate(static_cast<int>(film.size() / sizeof(shared::FilmPixel)) / rows);
  std::memcpy(
      &sums.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(sums.width) * kFloats],
      film.data(), film.size());
  std::fill_n(samples.begin() + row, rows, count);
}

void FilmState::takeFinished(const Image& image, int rows, std::uint32_t count) {
  allocate(image.width);
  const std::size_t pixels = static_cast<std::size_t>(rows) * static_cast<std::size_t>(image.width);
  for (std::size_t i = 0; i < pixels; ++i) {
    std::copy_n(&image.pixels[i * 3], 3, &sums.pixels[i * kFloats]);
    sums.pixels[i * kFloats + 3] = 1.0F;
  }
  std::fill_n(samples.begin(), rows, count);
  finishedRows = rows;
}

void FilmState::refuse(const std::string& reason) const {
  throw Error(ExitCode::Usage, fmt::format("cannot resume from \"{}\": {}", file, reason));
}

void FilmState::allocate(int width) {
  if (!empty()) return;
  sums.width = width;
  sums.height = static_cast<int>(samples.size());
  sums.channels = {"sum.R",      "sum.G",      "sum.B",      "sum.A",
                   "sum.rest.R", "sum.rest.G", "sum.rest.B", "sum.rest.A"};
  sums.pixels.assign(static_cast<std::size_t>(width) * samples.size() * kFloats, 0.0F);
}

}  // namespace laver
