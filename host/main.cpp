#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>

#include "commands/commands.h"
#include "commands/options.h"
#include "commands/process.h"
#include "show/view.h"

namespace {

using namespace laver;

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
  compareApp->add_option("--traversal", compare.vulkan.traversal,
                         "for --explain: lane, packet, packet32 or packet64");
  const CLI::Option* tolerance = compareApp->add_option(
      "--tolerance", compare.tolerance, "exit code 5 if the metric of a channel is beyond it");
  compareApp->add_option("--metric", compare.metric, "what the tolerance bounds")
      ->check(CLI::IsMember({"max", "p999", "rmse", "relmse"}));
  compareApp->add_option("--out", compare.out, "folder for difference.exr and difference.png")
      ->type_name("DIR");
  ViewCommand view;
  CLI::App* viewApp = app.add_subcommand("view", "Shows one or two pictures in a window");
  viewApp->add_option("a", view.a, "picture")->type_name("A.exr")->required();
  viewApp->add_option("b", view.b, "picture to hold against it")->type_name("B.exr");
  viewApp->footer(viewKeys());
  ChartCommand chart;
  CLI::App* chartApp =
      app.add_subcommand("chart", "Draws speed against accuracy of all ways to render a scene");
  addChartOptions(*chartApp, chart);
  const CLI::App* devicesApp = app.add_subcommand("devices", "Lists Vulkan devices");
  PlanCommand plan;
  CLI::App* planApp = app.add_subcommand(
      "plan", "Prints how a scene would be rendered, what is left out and why, without rendering");
  addPlanOptions(*planApp, plan);
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
  if (viewApp->parsed()) return static_cast<int>(run(view));
  if (chartApp->parsed()) return static_cast<int>(run(chart));
  if (devicesApp->parsed()) return static_cast<int>(runDevices());
  if (planApp->parsed()) return static_cast<int>(run(plan));
  if (schemaApp->parsed()) return static_cast<int>(runSchema(schemaJson));
  if (render.scene.empty()) return fail(ExitCode::Usage, "no scene given; see laver --help");
  if (std::filesystem::path(render.scene).extension() == ".exr") {
    view.a = render.scene;
    return static_cast<int>(run(view));
  }
  return static_cast<int>(run(render));
}

}  // namespace

int main(int argc, char** argv) {
  prepareProcess();
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
