#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "commands/commands.h"
#include "commands/standard_output.h"

namespace {

using namespace laver;

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
    if (!one) throw CLI::ValidationError(option, "expected " + expected + ", not \"" + name + '"');
    if (std::find(all.begin(), all.end(), *one) != all.end())
      throw CLI::ValidationError(option, name + " is named twice");
    all.push_back(*one);
  }
  return all;
}

std::string layerList() {
  std::string list;
  for (const char* name : layerNames()) list += std::string(list.empty() ? "" : ", ") + name;
  return list;
}

/// The options that change how a scene is rendered.
void addSceneOptions(CLI::App& app, SceneCommand& command) {
  app.add_option("scene", command.scene, "Nori scene, SCENE.xml")->type_name("SCENE.xml");
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
           const auto all = named("--integrator", text, integratorFromName,
                                  "normals, direct_whitted, depth, av or ao");
           command.overrides.integrator = all.front();
           command.options.more.assign(all.begin() + 1, all.end());
         },
         "normals, direct_whitted, depth, av or ao; further ones, after commas, go beside it as "
         "layers")
      ->type_name("NAME,...");
  app.add_option_function<std::string>(
         "--sampler",
         [&](const std::string& name) {
           command.overrides.sampler = samplerFromName(name);
           if (!command.overrides.sampler)
             throw CLI::ValidationError("--sampler",
                                        "expected independent, stratified or sobol, not " + name);
         },
         "independent, stratified or sobol")
      ->type_name("NAME");
  app.add_option_function<std::string>(
         "--layers",
         [&](const std::string& text) {
           command.options.layers = named("--layers", text, layerFromName, layerList());
         },
         "layers of the EXR file: " + layerList())
      ->type_name("NAME,...");
  app.add_option_function<std::string>(
         "--size",
         [&](const std::string& text) {
           const auto v = integers("--size", text, 'x', 2, "WIDTHxHEIGHT");
           command.overrides.size = glm::ivec2(v[0], v[1]);
         },
         "size of the film in pixels")
      ->type_name("WxH");
  app.add_option_function<std::string>(
         "--crop",
         [&](const std::string& text) {
           const auto v = integers("--crop", text, ',', 4, "x0,y0,x1,y1");
           command.options.crop = Crop{v[0], v[1], v[2], v[3]};
         },
         "render pixels x0 <= x < x1, y0 <= y < y1 only")
      ->type_name("x0,y0,x1,y1");
  app.add_option("--device", command.vulkan.device, "index, part of the name, or cpu");
  app.add_option("--traversal", command.vulkan.traversal, "lane or packet");
  app.add_flag("--nori-compat", command.options.noriCompat,
               "as Nori: filter weights from a table, pictures of 8 bits taken for linear");
  app.add_option("-t,--threads", command.options.threads, "threads, 0 for all")
      ->check(CLI::Range(0U, 4096U));
}

void addRenderOptions(CLI::App& app, RenderCommand& command) {
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
  app.add_flag_callback(
      "-b,--nogui,--no-gui", [] {}, "accepted as Nori does; there is no window");
}

/// CLI11 flags take no text; --stats=FILE.json is taken out before it looks.
std::vector<std::string> takeStatsFile(int argc, char** argv, std::string& file) {
  std::vector<std::string> arguments;
  for (int i = argc - 1; i > 0; --i) {  // CLI11 wants them reversed
    const std::string argument = argv[i];
    if (argument.rfind("--stats=", 0) == 0)
      file = argument.substr(8);
    else
      arguments.push_back(argument);
  }
  return arguments;
}

int fail(ExitCode code, const std::string& message) {
  std::fprintf(stderr, "laver: %s\n", message.c_str());
  return static_cast<int>(code);
}

int dispatch(int argc, char** argv) {
  CLI::App app("Renders Nori scenes with Vulkan compute.", "laver");
  app.set_version_flag("--version", std::string("laver ") + LAVER_VERSION);
  RenderCommand render;
  addRenderOptions(app, render);
  CompareCommand compare;
  CLI::App* compareApp =
      app.add_subcommand("compare", "Measures how a picture differs from another");
  compareApp->add_option("a", compare.a, "picture")->type_name("A.exr");
  compareApp->add_option("b", compare.b, "reference")->type_name("B.exr");
  compareApp
      ->add_option("--explain", compare.explain,
                   "render a scene and explain each difference from the reference, instead")
      ->type_name("SCENE.xml");
  compareApp->add_option("--device", compare.vulkan.device, "for --explain: as in rendering");
  compareApp->add_option("--traversal", compare.vulkan.traversal, "for --explain: lane or packet");
  const CLI::Option* tolerance = compareApp->add_option(
      "--tolerance", compare.tolerance, "exit code 5 if the metric of a channel is beyond it");
  compareApp->add_option("--metric", compare.metric, "what the tolerance bounds")
      ->check(CLI::IsMember({"max", "p999", "rmse", "relmse"}));
  compareApp->add_option("--out", compare.out, "folder for difference.exr and difference.png")
      ->type_name("DIR");
  const CLI::App* devicesApp = app.add_subcommand("devices", "Lists Vulkan devices");
  PlanCommand plan;
  CLI::App* planApp = app.add_subcommand(
      "plan", "Prints how a scene would be rendered, what is left out and why, without rendering");
  addSceneOptions(*planApp, plan);
  planApp->add_flag("--json", plan.json, "print JSON");
  CLI::App* schemaApp = app.add_subcommand("schema", "Lists all that a scene file may hold");
  bool schemaJson = false;
  schemaApp->add_flag("--json", schemaJson, "as JSON");
  app.require_subcommand(0, 1);

  try {
    app.parse(takeStatsFile(argc, argv, render.statsFile));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      app.exit(error);
      flushStandardOutput();
      return static_cast<int>(ExitCode::Ok);
    }
    return fail(ExitCode::Usage, error.what());
  }
  compare.judged = tolerance->count() != 0;
  const bool comparable = compare.explain.empty() ? !compare.b.empty() : compare.a.empty();
  if (compareApp->parsed() && !comparable)
    return fail(ExitCode::Usage, "compare takes two pictures, or --explain SCENE.xml");
  if (compareApp->parsed()) return static_cast<int>(run(compare));
  if (devicesApp->parsed()) return static_cast<int>(runDevices());
  if (planApp->parsed()) {
    if (plan.scene.empty())
      return fail(ExitCode::Usage, "plan takes a scene: laver plan SCENE.xml");
    return static_cast<int>(run(plan));
  }
  if (schemaApp->parsed()) return static_cast<int>(runSchema(schemaJson));
  if (render.scene.empty()) return fail(ExitCode::Usage, "no scene given; see laver --help");
  return static_cast<int>(run(render));
}

}  // namespace

int main(int argc, char** argv) {
  // A closed pipe or a file beyond a limit is an error like any other, not the end of the process.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  occupyStandardDescriptors();
  try {
    return dispatch(argc, argv);
  } catch (const Error& error) {
    // Scene errors are lines that begin with the file's name.
    if (error.code() == ExitCode::Scene) {
      std::fprintf(stderr, "%s\n", error.what());
      return static_cast<int>(error.code());
    }
    return fail(error.code(), error.what());
  } catch (const std::bad_alloc&) {
    return fail(ExitCode::Output, "out of memory");
  } catch (const std::exception& error) {
    return fail(ExitCode::Output, std::string("internal error: ") + error.what());
  }
}
