#include "commands/output.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <future>
#include <iostream>
#include <numbers>
#include <optional>
#include <span>

#include "commands/resume.h"
#include "core/atomic_file.h"
#include "core/hash.h"
#include "image/io.h"

namespace laver {
namespace {

/// Hash of a regular file; a pipe cannot be read a second time.
std::string fileHash(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return "none: not a regular file";
  const std::optional<std::string> hash = hashOfFile(file);
  return hash ? "xxh3:" + *hash : "none: not readable";
}

/// Camera space to normalised device coordinates: x from 0 at the left edge of the film to 1 at
/// the right, y from 0 at the top, z from 0 at the near to 1 at the far plane.
glm::dmat4 cameraToNdc(const Camera& camera) {
  const double t = std::tan(camera.fov * std::numbers::pi / 360.0);
  const double aspect = static_cast<double>(camera.width) / camera.height;
  const double depth = camera.farClip / (camera.farClip - camera.nearClip);
  glm::dmat4 m(0.0);
  m[0][0] = -0.5 / t;  // +x of camera space is left
  m[1][1] = -0.5 * aspect / t;
  m[2] = {0.5, 0.5, depth, 1.0};
  m[3][2] = -camera.nearClip * depth;
  return m;
}

}  // namespace

void print(const RenderCommand& command, const std::string& text) {
  if (!command.quiet) std::cout << text;
}

std::filesystem::path outputOf(const RenderCommand& command) {
  std::filesystem::path exr = command.output;
  if (exr.empty()) exr = std::filesystem::path(command.scene).replace_extension(".exr");
  if (exr.extension() != ".exr")
    throw Error(ExitCode::Usage,
                fmt::format("-o {}: expected a name that ends in .exr", exr.string()));
  checkReplaceable(exr.string());
  checkReplaceable(std::filesystem::path(exr).replace_extension(".png").string());
  if (command.resume) checkReplaceable(statePath(exr).string());
  return exr;
}

Metadata metadataOf(const Scene& scene, const Rendered& rendered, const Stats& stats,
                    double renderSeconds) {
  const glm::dmat4 worldToCamera = glm::inverse(scene.camera.toWorld);
  Metadata metadata = {{"comments", fmt::format("laver {} of {}", LAVER_VERSION, scene.file)},
                       {"laverVersion", std::string(LAVER_VERSION)},
                       {"device", stats.device},
                       {"driver", stats.driver},
                       {"sceneHash", fileHash(scene.file)},
                       {"seed", std::to_string(scene.sampler.seed)},
                       {"sampler", std::string(scene.sampler.row->name)},
                       {"renderTimeSeconds", renderSeconds},
                       {"samplesPerPixel", static_cast<int>(rendered.reached.samples)},
                       {"worldToCamera", worldToCamera},
                       {"worldToNDC", cameraToNdc(scene.camera) * worldToCamera}};
  if (stats.adaptive.error > 0.0) {
    metadata["errorWanted"] = stats.adaptive.error;
    metadata["samplesPerPixelAverage"] = stats.adaptive.average;
  }
  if (!rendered.whole()) {
    metadata["samplesPerPixelWanted"] = static_cast<int>(scene.sampler.sampleCount);
    metadata["rowsReached"] = rendered.reached.rows;
    metadata["rowsComplete"] = rendered.reached.wholeRows;
  }
  return metadata;
}

void writePictures(const std::filesystem::path& exr, const Image& image, const Metadata& metadata,
                   unsigned threads) {
  const std::string png = std::filesystem::path(exr).replace_extension(".png").string();
  auto pngDone = std::async(std::launch::async, [&] { writePng(png, image); });
  writeExr(exr.string(), image, metadata, threads);
  pngDone.get();
}

void writeStats(const RenderCommand& command, const Stats& stats) {
  if (command.stats == RenderCommand::kToStderr) std::cerr << stats.text();
  if (command.stats.empty() || command.stats == RenderCommand::kToStderr) return;
  const std::string text = stats.json().dump(2) + '\n';
  std::error_code error;
  const auto status = std::filesystem::status(command.stats, error);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) {
    replaceFile(command.stats, std::as_bytes(std::span(text)));
    return;
  }
  std::ofstream file(command.stats);  // for example a pipe
  if (!(file << text).flush()) throw Error(ExitCode::Output, command.stats + ": cannot be written");
}

}  // namespace laver
