// laver_embree SCENE.xml: the picture that laver renders, by Embree, with the same samples and
// filter and the same options, so that `laver chart --program` can run it.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <future>
#include <nlohmann/json.hpp>

#include "bench/embree_film.h"
#include "bench/embree_pass.h"
#include "bench/embree_scene.h"
#include "core/error.h"
#include "core/parallel.h"
#include "image/io.h"
#include "render/camera_data.h"

namespace laver::bench {
namespace {

/// Samples of a pixel in one pass: laver's own number.
constexpr std::uint32_t kPass = 16;

struct Command {
  std::string scene, output = "embree.exr", stats, size, filter, sampler, isa, ignored;
  std::uint32_t samples = 0;
  unsigned threads = 0;
  bool quiet = false;
};

SceneData pack(const Scene& scene) {
  SceneData data;
  data.constants = specialise(scene, {});
  data.space = normalisationOf(scene);
  packCamera(scene, data);
  packSampler(scene, data);
  if (!scene.meshes.empty())
    data.params.albedo = glm::vec4(glm::vec3(scene.meshes.front().bsdf.albedo), 0.0F);
  if (scene.integrator.is(integrators::directWhitted))
    for (const PointLight& light : scene.lights)
      data.lights.push_back({glm::vec3(data.space.apply(light.position)), 0.0F,
                             glm::vec3(light.radiance * (data.space.scale * data.space.scale)),
                             0.0F});
  return data;
}

std::vector<glm::vec3> albedosOf(const Scene& scene, const SceneData& data) {
  std::vector<glm::vec3> albedos;
  if (data.constants[shared::SPEC_ALBEDOS] == 0) return albedos;
  for (const Mesh& mesh : scene.meshes)
    albedos.insert(albedos.end(), mesh.triangles.size(), glm::vec3(mesh.bsdf.albedo));
  return albedos;
}

void render(const Command& command) {
  SceneOverrides overrides;
  if (command.samples != 0) overrides.sampleCount = command.samples;
  if (!command.filter.empty()) {
    overrides.filter = rowCalled(filterRows(), command.filter);
    if (overrides.filter == nullptr) throw Error(ExitCode::Usage, "no filter " + command.filter);
  }
  if (!command.sampler.empty()) {
    overrides.sampler = rowCalled(samplerRows(), command.sampler);
    if (overrides.sampler == nullptr) throw Error(ExitCode::Usage, "no sampler " + command.sampler);
  }
  int width = 0, height = 0;
  if (std::sscanf(command.size.c_str(), "%dx%d", &width, &height) == 2)
    overrides.size = glm::ivec2(width, height);
  const Scene scene = loadScene(command.scene, overrides).scene;
  if (scene.integrator.is(integrators::normals))
    throw Error(ExitCode::Scene, "Embree's side renders depth and direct_whitted");
  const unsigned threads = threadCount(command.threads);
  const EmbreeDevice device("threads=" + std::to_string(threads) +
                            (command.isa.empty() ? "" : ",isa=" + command.isa));
  const EmbreeMesh mesh(scene);
  const EmbreeScene tree(device, mesh, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_MEDIUM);
  const SceneData data = pack(scene);
  const std::uint32_t samples = scene.sampler.sampleCount;
  EmbreePass pass(data, std::min(samples, kPass), albedosOf(scene, data));
  EmbreeFilm film(scene.filter, scene.camera.width, scene.camera.height);
  double trace = 0, reconstruct = 0;
  for (std::uint32_t first = 0; first < samples; first += kPass) {
    const std::uint32_t count = std::min(samples - first, kPass);
    const EmbreeCall call{tree.get(), 16, count == kPass};
    trace += pass.run(call, first, count, threads).seconds;
    const auto start = std::chrono::steady_clock::now();
    pass.addTo(film, call, count, threads);
    reconstruct += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  const Image image = film.image();
  auto png = std::async(std::launch::async, [&] {
    writePng(std::filesystem::path(command.output).replace_extension(".png").string(), image);
  });
  writeExr(command.output, image, {{"comments", "Embree " + device.description()}});
  png.get();
  if (command.stats.empty()) return;
  std::ofstream(command.stats) << nlohmann::json{
      {"device", "Embree " + device.description()},
      {"seconds", {{"trace", trace}, {"reconstruct", reconstruct}}},
      {"samples", {{"total", static_cast<double>(samples) * image.width * image.height}}}};
}

int dispatch(int argc, char** argv) {
  Command command;
  CLI::App app("Renders what laver renders by Embree.", "laver_embree");
  app.add_option("scene", command.scene)->required();
  app.add_option("-o", command.output);
  app.add_option("--spp", command.samples);
  app.add_option("--size", command.size);
  app.add_option("--filter", command.filter);
  app.add_option("--sampler", command.sampler);
  app.add_option("--stats", command.stats);
  app.add_option("-t,--threads", command.threads);
  app.add_option("--isa", command.isa, "what Embree is held to: avx2, say; default: all it can");
  app.add_option("--device", command.ignored, "taken, and of no effect");
  app.add_flag("-q,--quiet", command.quiet, "taken: nothing is printed");
  CLI11_PARSE(app, argc, argv);
  render(command);
  return 0;
}

}  // namespace
}  // namespace laver::bench

int main(int argc, char** argv) {
  try {
    return laver::bench::dispatch(argc, argv);
  } catch (const laver::Error& error) {
    std::fprintf(stderr, "laver_embree: %s\n", error.what());
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "laver_embree: %s\n", error.what());
    return 1;
  }
}
