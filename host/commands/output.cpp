#include "commands/output.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <future>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <span>

#include "commands/resume.h"
#include "core/atomic_file.h"
#include "core/beside.h"
#include "core/hash.h"
#include "image/io.h"
#include "render/tiling.h"
#include "scene/mesh_files.h"

namespace laver {
namespace {

/// Hash of a regular file; a pipe cannot be read a second time.
std::string fileHash(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return "none: not a regular file";
  const std::optional<std::string> hash = hashOfFile(file);
  return hash ? "xxh3:" + *hash : "none: not readable";
}

/// The attribute worldToCamera as OpenEXR states it (ImfStandardAttributes.h): left-handed, +x to
/// the right of the picture, +y up, +z into the scene. In Nori's camera space +x is to the left.
glm::dmat4 toCamera(const Camera& camera) {
  glm::dmat4 mirror(1.0);
  mirror[0][0] = -1.0;
  return mirror * glm::inverse(camera.toWorld);
}

/// Camera space, as above, to normalised device coordinates: x from 0 at the left edge of the film
/// to 1 at the right, y from 0 at the top, z from 0 at the near to 1 at the far plane.
glm::dmat4 cameraToNdc(const Camera& camera) {
  const double t = std::tan(camera.fov * std::numbers::pi / 360.0);
  const double aspect = static_cast<double>(camera.width) / camera.height;
  const double depth = camera.farClip / (camera.farClip - camera.nearClip);
  glm::dmat4 m(0.0);
  m[0][0] = 0.5 / t;
  m[1][1] = -0.5 * aspect / t;
  m[2] = {0.5, 0.5, depth, 1.0};
  m[3][2] = -camera.nearClip * depth;
  return m;
}

/// Where a picture, or a shard of it, lies without -o: beside the scene, if that is a file.
std::filesystem::path besideScene(const std::string& scene, const std::optional<Shard>& shard) {
  std::error_code error;
  const std::string folder = std::filesystem::absolute(scene, error).parent_path().string() + "/";
  if (!std::filesystem::is_regular_file(scene, error) || folder.starts_with("/dev/") ||
      folder.starts_with("/proc/"))
    throw Error(ExitCode::Usage,
                fmt::format("-o OUT.exr is needed: no picture can lie beside \"{}\"", scene));
  const std::string extension =
      shard ? fmt::format(".{}-of-{}.exr", shard->index, shard->count) : ".exr";
  return std::filesystem::path(scene).replace_extension(extension);
}

/// Throws if a picture would replace a file that the scene is made of.
void checkNotOfScene(const std::filesystem::path& picture, const Scene& scene) {
  for (const std::filesystem::path& file : filesOf(scene)) {
    std::error_code error;
    if (std::filesystem::equivalent(file, picture, error))
      throw Error(ExitCode::Usage,
                  fmt::format("\"{}\" would be replaced, and the scene reads it: -o names another",
                              picture.string()));
  }
}

/// The PNG of a picture.
std::filesystem::path pngOf(std::filesystem::path exr) { return exr.replace_extension(".png"); }

/// Throws unless the name ends in .exr.
void checkIsExr(const std::filesystem::path& exr) {
  if (exr.extension() != ".exr")
    throw Error(ExitCode::Usage,
                fmt::format("-o {}: expected a name that ends in .exr", exr.string()));
}

}  // namespace

std::vector<std::filesystem::path> filesOf(const Scene& scene) {
  std::vector<std::string> names = {scene.file};
  if (scene.environment) names.push_back(scene.environment->filename);
  for (const Mesh& mesh : scene.meshes) {
    names.push_back(mesh.name);
    for (const NamedTexture& named : mesh.bsdf.textures) names.push_back(named.texture.filename);
    if (mesh.light && mesh.light->texture) names.push_back(mesh.light->texture->filename);
  }
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names)
    if (!name.empty()) files.push_back(xml::findFile(scene.file, name));
  return files;
}

std::filesystem::path pictureFile(const std::filesystem::path& exr) {
  checkIsExr(exr);
  checkReplaceable(exr.string());
  checkReplaceable(pngOf(exr).string());
  return exr;
}

void print(const RenderCommand& command, const std::string& text) {
  if (!command.quiet) std::cout << text;
}

std::filesystem::path outputOf(const RenderCommand& command, const Scene& scene) {
  const std::filesystem::path exr = command.output.empty()
                                        ? besideScene(command.scene, command.options.shard)
                                        : std::filesystem::path(command.output);
  checkIsExr(exr);
  std::vector<std::filesystem::path> files = {exr};
  if (!command.options.shard) files.push_back(pngOf(exr));
  for (const auto& file : files) {
    checkReplaceable(file.string());
    checkNotOfScene(file, scene);
  }
  if (command.resume) checkReplaceable(statePath(exr).string());
  return exr;
}

Metadata metadataOf(const Scene& scene, const Rendered& rendered, const Stats& stats,
                    double renderSeconds) {
  const glm::dmat4 worldToCamera = toCamera(scene.camera);
  Metadata metadata = {{"comments", fmt::format("laver {} of {}", LAVER_VERSION, scene.file)},
                       {"laverVersion", std::string(LAVER_VERSION)},
                       {"device", stats.device},
                       {"driver", stats.driver},
                       {"sceneHash", fileHash(scene.file)},
                       {"seed", std::to_string(scene.sampler.seed)},
                       {"sampler", std::string(scene.sampler.row->name)},
                       {"filterReach", std::to_string(apronOf(scene.filter.radius))},
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
  const std::string pngName = pngOf(exr).string();
  auto png = std::async(kBeside, [&] { return encodePng(image, pngName); });
  const std::vector<std::byte> bytes = encodeExr(exr.string(), image, metadata, threads);
  AtomicFile exrFile(exr.string()), pngFile(pngName);
  exrFile.write(bytes);
  pngFile.write(png.get());
  // After both can no longer fail for lack of memory or space.
  exrFile.commit();
  pngFile.commit();
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
