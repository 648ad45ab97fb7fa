#include "commands/metadata.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <optional>

#include "core/hash.h"

namespace laver {
namespace {

/// A pipe has been read and holds its bytes no more.
std::string fileHash(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return "none: not a regular file";
  const std::optional<std::string> hash = hashOfFile(file);
  return hash ? "xxh3:" + *hash : "none: not readable";
}

}  // namespace

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

}  // namespace laver
