#include "commands/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <sstream>

namespace laver {
namespace {

/// Exactly the integers in `text`, divided by `separator`, or a CLI error that says what was
/// expected.
std::vector<int> integers(const std::string& option, const std::string& text, char separator,
                          std::size_t count, const char* expected) {
  std::vector<int> values;
  std::istringstream in(text + separator);
  for (std::string part; std::getline(in, part, separator);) {
    int value = 0;
    std::size_t used = 0;
    try {
      value = std::stoi(part, &used);
    } catch (const std::exception&) {
    }
    if (part.empty() || used != part.size() || std::isspace(static_cast<unsigned char>(part[0])))
      values.resize(count + 1);
    values.push_back(value);
  }
  if (values.size() != count)
    throw CLI::ValidationError(option, "expected " + std::string(expected) + ", not " + text);
  return values;
}

/// What the names in `text`, with commas between, stand for; each once.
template <class T>
std::vector<T> named(const std::string& option, const std::string& text,
                     std::optional<T> (*find)(const std::string&), const std::string& expected) {
  std::vector<T> all;
  std::istringstream in(text + ',');
  for (std::string name; std::getline(in, name, ',');) {
    const std::optional<T> one = find(name);
    if (!one)
      throw CLI::ValidationError(option, fmt::format("expected {}, not \"{}\"", expected, name));
    if (std::find(all.begin(), all.end(), *one) != all.end())
      throw CLI::ValidationError(option, name + " is named twice");
    all.push_back(*one);
  }
  return all;
}

/// An integrator by its name, as `named` takes it.
std::optional<IntegratorUse> integratorCalled(const std::string& name) {
  const IntegratorRow* row = rowCalled(integratorRows(), name);
  return row == nullptr ? std::nullopt : std::optional(IntegratorUse{row});
}

std::string layerList() {
  std::string list;
  for (const char* name : layerNames()) list += std::string(list.empty() ? "" : ", ") + name;
  return list;
}

void addSize(CLI::App& app, std::optional<glm::ivec2>& size, const std::string& meaning) {
  app.add_option_function<std::string>(
         "--size",
         [&size](const std::string& text) {
           const auto v = integers("--size", text, 'x', 2, "WIDTHxHEIGHT");
           size = glm::ivec2(v[0], v[1]);
         },
         meaning)
      ->type_name("WxH");
}

/// The options that change how a scene is rendered.
void addSceneOptions(CLI::App& app, SceneCommand& command) {
  app.add_option("--spp", command.overrides.sampleCount, "samples a pixel")
      ->check(CLI::Range(1U, 1U << 20));
  app.add_option("--error", command.options.error,
                 "adaptive sampling: stop where a pixel's standard error, 1 being white, is below "
                 "E; --spp is the most a pixel gets")
      ->type_name("E")
      ->check(CLI::PositiveNumber & CLI::Range(0.0, 1e6));
  app.add_option("--seed", command.overrides.seed, "seed of the sampler");
  app.add_option_function<std::string>(
         "--integrator",
         [&](const std::string& text) {
           const auto all =
               named("--integrator", text, integratorCalled, namesOf(integratorRows()));
           command.overrides.integrator = all.front();
           command.options.more.assign(all.begin() + 1, all.end());
         },
         namesOf(integratorRows()) + "; further ones, after commas, go beside it as layers")
      ->type_name("NAME,...");
  app.add_option_function<std::string>(
         "--sampler",
         [&](const std::string& name) {
           command.overrides.sampler = rowCalled(samplerRows(), name);
           if (command.overrides.sampler == nullptr)
             throw CLI::ValidationError("--sampler",
                                        "expected " + namesOf(samplerRows()) + ", not " + name);
         },
         namesOf(samplerRows()))
      ->type_name("NAME");
  app.add_option_function<std::string>(
         "--layers",
         [&](const std::string& text) {
           command.options.layers = named("--layers", text, layerFromName, layerList());
         },
         "layers of the EXR file: " + layerList())
      ->type_name("NAME,...");
  app.add_option_function<std::string>(
         "--filter",
         [&](const std::string& name) {
           command.overrides.filter = rowCalled(filterRows(), name);
           if (command.overrides.filter == nullptr)
             throw CLI::ValidationError("--filter",
                                        "expected " + namesOf(filterRows()) + ", not " + name);
         },
         "reconstruction filter: " + namesOf(filterRows()))
      ->type_name("NAME");
  addSize(app, command.overrides.size, "size of the film in pixels");
  app.add_option_function<std::string>(
         "--crop",
         [&](const std::string& text) {
           const auto v = integers("--crop", text, ',', 4, "x0,y0,x1,y1");
           command.options.crop = Crop{v[0], v[1], v[2], v[3]};
         },
         "render pixels x0 <= x < x1, y0 <= y < y1 only")
      ->type_name("x0,y0,x1,y1");
  app.add_option("--device", command.vulkan.device, "index, part of the name, or cpu");
  app.add_option("--traversal", command.vulkan.traversal, "lane, packet, packet32 or packet64");
  app.add_flag("--nori-compat", command.options.noriCompat,
               "as Nori: filter weights from a table, pictures of 8 bits taken for linear");
  app.add_option("-t,--threads", command.options.threads, "threads, 0 for all")
      ->check(CLI::Range(0U, 4096U));
}

}  // namespace

void addRenderOptions(CLI::App& app, RenderCommand& command) {
  app.add_option("scene", command.scene, "Nori scene, or a picture, FILE.exr, to view")
      ->type_name("SCENE.xml");
  addSceneOptions(app, command);
  app.add_option("-o,--output,--outfile", command.output, "picture to write; a .png goes beside it")
      ->type_name("OUT.exr");
  app.add_flag("--reference", command.reference, "render in double precision on the CPU");
  app.add_flag("--resume", command.resume,
               "go on from OUT.state.exr if there is one, and leave one to go on from");
  app.add_flag("--validate", command.vulkan.validate, "make every validation message an error");
  app.add_flag_callback(
      "--stats", [&] { command.stats = true; },
      "print figures to stderr; --stats=FILE.json writes them");
  app.add_option_function<std::string>(
         "--display-server",
         [&](const std::string& text) {
           try {
             command.displayServer = viewerAddress(text);
           } catch (const Error& error) {
             throw CLI::ValidationError(error.what());
           }
         },
         "show the picture in tev or HDRView while it renders")
      ->type_name("HOST:PORT");
  app.add_flag("-q,--quiet", command.quiet, "print nothing but warnings and errors");
  app.add_flag("--gui", command.gui, "show the picture in a window while it renders");
  app.add_flag_callback(
      "-b,--nogui,--no-gui", [&] { command.gui = false; },
      "no window, whatever --gui says; the default");
}

void addChartOptions(CLI::App& app, ChartCommand& command) {
  app.add_option("scene", command.scene, "Nori scene, SCENE.xml")
      ->type_name("SCENE.xml")
      ->required();
  app.add_option("--out", command.out, "folder of the chart; default SCENE-chart beside the scene")
      ->type_name("DIR");
  addSize(app, command.size, "size of the film in pixels; default 256 wide");
  app.add_option("--device", command.device, "as in rendering");
  app.add_option("-t,--threads", command.threads, "as in rendering")->check(CLI::Range(0U, 4096U));
  app.add_option("--runs", command.runs, "renders of each point; the median counts")
      ->check(CLI::Range(1U, 1000U));
  app.add_option("--spp", command.samples, "samples per pixel at most")
      ->check(CLI::Range(1U, 1U << 20));
  app.add_option("--reference-spp", command.referenceSamples,
                 "samples per pixel of each half of the reference")
      ->check(CLI::Range(1U, 1U << 20));
  app.add_option("--peer", command.peers,
                 "another renderer that takes laver's options; may be repeated")
      ->type_name("NAME COMMAND")
      ->type_size(2)
      ->expected(1, 1000);
  app.add_flag("-q,--quiet", command.quiet, "print nothing but warnings and errors");
}

void addPlanOptions(CLI::App& app, PlanCommand& command) {
  app.add_option("scene", command.scene, "Nori scene, SCENE.xml")
      ->type_name("SCENE.xml")
      ->required();
  addSceneOptions(app, command);
  app.add_flag("--json", command.json, "print JSON");
}

}  // namespace laver
