// What each specialisation to the scene saves: every constant made generic alone, beside the
// specialised render, in turns in one run. laver_savings [--rounds N] [--warm]
// [OUT.json] [SCENE.xml ...]
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "bench/report.h"
#include "bench/scenes.h"
#include "core/error.h"
#include "render/renderer.h"
#include "render/specialise.h"

namespace laver::bench {
namespace {

struct Constant {
  const char* name;
  std::uint32_t which;
};

// One bit of generalise() each; the last is all that changes a kernel.
constexpr std::array kConstants = {
    Constant{"stack", 1U << shared::SPEC_STACK},
    Constant{"vertex normals", 1U << shared::SPEC_NORMALS},
    Constant{"materials", 1U << shared::SPEC_ALBEDOS},
    Constant{"lights", 1U << shared::SPEC_LIGHTS},
    Constant{"shadow rays where n.l > 0", 1U << shared::SPEC_DARK_SIDES},
    Constant{"no camera rays", 1U << shared::SPEC_HITS},
    Constant{"sampler tables", 1U << shared::SPEC_JUMP_LEVELS},
    Constant{"filter", 1U << shared::SPEC_FILTER},
    Constant{"filter's reach", 1U << shared::SPEC_APRON},
    Constant{"indices", 1U << shared::SPEC_INDEX_BYTES},
    Constant{"textures", 1U << shared::SPEC_TEXTURES},
    Constant{"pictures", 1U << shared::SPEC_IMAGES},
    Constant{"background", 1U << shared::SPEC_BACKGROUND},
    Constant{"spheres", 1U << shared::SPEC_SPHERES},
    Constant{"all of them", kAllConstants}};

struct Side {
  Constant constant;
  std::vector<double> trace, reconstruct, compile, cold;
};

void renderOnce(const Scene& scene, Side& side, bool counted, bool cold) {
  // Without Mesa's cache of machine code, as on a first run.
  ::setenv("MESA_SHADER_CACHE_DISABLE", cold ? "true" : "false", 1);
  VulkanOptions vulkan;
  vulkan.device = "cpu";
  vulkan.generic = side.constant.which;
  Stats stats;
  Renderer(vulkan).render(scene, {}, stats);
  if (cold) side.cold.push_back(stats.seconds.compile);
  if (!counted || cold) return;
  side.trace.push_back(stats.seconds.trace);
  side.reconstruct.push_back(stats.seconds.reconstruct);
  side.compile.push_back(stats.seconds.compile);
}

/// Whether a kernel of these constants looks at what a generic one would.
bool applies(const Constant& constant, const SpecConstants& c) {
  if (constant.which == 1U << shared::SPEC_DARK_SIDES)
    return c[shared::SPEC_LIGHTS] != shared::LIGHTS_NONE;
  if (constant.which == 1U << shared::SPEC_INDEX_BYTES &&
      c[shared::SPEC_NORMALS] + c[shared::SPEC_ALBEDOS] == 0)
    return false;
  return generalise(c, constant.which) != c;
}

nlohmann::json benchScene(const std::string& name, const Scene& scene, int rounds, bool cold) {
  const SpecConstants needed = specialise(scene, {});
  std::vector<Side> sides{{{"specialised", 0}, {}, {}, {}, {}}};
  for (const Constant& constant : kConstants)
    if (applies(constant, needed)) sides.push_back({constant, {}, {}, {}, {}});
  // The first round may make machine code.
  for (int round = 0; round <= rounds; ++round)
    for (Side& side : sides) renderOnce(scene, side, round > 0, false);
  for (Side& side : sides)
    if (cold) renderOnce(scene, side, true, true);

  fmt::print("\n{}, {}x{}, {} samples: ms, and as generic times as specialised\n", name,
             scene.camera.width, scene.camera.height, scene.sampler.sampleCount);
  fmt::print("  {:<28}{:>16}{:>16}{:>16}{:>16}\n", "", "trace", "reconstruct", "compile", "cold");
  nlohmann::json rows;
  for (const Side& side : sides) {
    std::string text = fmt::format("  {:<28}", side.constant.name);
    nlohmann::json row{{"constant", side.constant.name}};
    const auto column = [&](const char* what, std::vector<double> Side::*times) {
      const double own = median(side.*times), base = median(sides.front().*times);
      row[what] = {{"median", own}, {"ratio", own / base}, {"seconds", side.*times}};
      text += fmt::format("{:>9.1f} x{:<5.2f}", own * 1e3, own / base);
    };
    column("trace", &Side::trace);
    column("reconstruct", &Side::reconstruct);
    column("compile", &Side::compile);
    if (cold) column("cold", &Side::cold);
    rows.push_back(row);
    fmt::print("{}\n", text);
    std::fflush(stdout);
  }
  return {{"scene", name}, {"rows", rows}};
}

void run(int argc, char** argv) {
  int rounds = 5;
  bool cold = true;
  std::string file;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--rounds" && i + 1 < argc)
      rounds = std::atoi(argv[++i]);
    else if (argument == "--warm")
      cold = false;
    else if (argument.ends_with(".json"))
      file = argument;
    else
      names.push_back(argument);
  }
  if (names.empty())
    names = {"bunny-normals.xml", "bunny-whitted.xml", "cornell-two-lights.xml",
             "curved-normals.xml", "cornell-two-lights.xml without lights"};
  nlohmann::json all;
  for (const std::string& name : names) {
    SceneOverrides overrides;
    overrides.size = glm::ivec2(512, 512);
    overrides.sampleCount = 4;
    Scene scene = loadScene(sceneFile("scenes/" + name.substr(0, name.find(' '))), overrides).scene;
    if (name.find("without lights") != std::string::npos) scene.lights.clear();
    all.push_back(benchScene(name, scene, rounds, cold));
  }
  if (file.empty()) return;
  std::ofstream(file) << all.dump(1) << '\n';
}

}  // namespace
}  // namespace laver::bench

int main(int argc, char** argv) {
  try {
    laver::bench::run(argc, argv);
    return 0;
  } catch (const laver::Error& error) {
    std::cerr << error.what() << '\n';
    return static_cast<int>(error.code());
  }
}
