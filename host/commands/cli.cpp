#include "commands/cli.h"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>

#include "commands/cli_values.h"
#include "commands/process.h"
#include "image/measure.h"
#include "lab/suite/settings.h"
#include "show/view.h"

namespace laver {
namespace {

constexpr std::uint32_t kMaxSamples = 1U << 20;

CLI::Option* addScene(CLI::App& app, std::string& scene) {
  return app.add_option("SCENE.xml", scene, "Nori scene")->type_name("");
}

void addThreads(CLI::App& app, unsigned& threads) {
  app.add_option("-t,--threads", threads, "threads, 0 for all")->check(CLI::Range(0U, 4096U));
}

void addDevice(CLI::App& app, VulkanOptions& vulkan) {
  app.add_option("--device", vulkan.device, "index, part of the name, or cpu");
  app.add_option("--traversal", vulkan.traversal, "lane, packet, packet32 or packet64");
}

/// The name of a table row, or a user's file.
Names<IntegratorUse> integratorNames() {
  const auto find = [](const std::string& name) -> std::optional<IntegratorUse> {
    if (name.ends_with(".glsl")) return userIntegrator(name);
    const IntegratorRow* row = rowCalled(integratorRows(), name);
    return row == nullptr ? std::nullopt : std::optional(IntegratorUse{row});
  };
  return {find, namesOf(integratorRows()) + ", or a file FILE.glsl"};
}

/// Options that override parts of the scene.
void addOverrides(CLI::App& app, SceneCommand& command) {
  SceneOverrides& overrides = command.overrides;
  app.add_option("--spp", overrides.sampleCount, "samples per pixel")
      ->check(CLI::Range(1U, kMaxSamples));
  app.add_option("--seed", overrides.seed, "seed of the sampler");
  addSize(app, overrides.size, "size of the film in pixels");
  const Names<IntegratorUse> integrators = integratorNames();
  addNames(app, "--integrator",
           integrators.all + "; further ones, separated by commas, become layers", integrators,
           [&command](const std::vector<IntegratorUse>& all) {
             command.overrides.integrator = all.front();
             command.options.more.assign(all.begin() + 1, all.end());
           });
  addName(app, "--sampler", "", namesIn(samplerRows()),
          [&overrides](const SamplerRow* row) { overrides.sampler = row; });
  addName(app, "--filter", "reconstruction filter: ", namesIn(filterRows()),
          [&overrides](const FilterRow* row) { overrides.filter = row; });
  addName(app, "--dialect", "course whose meaning the scene has: ", namesIn(dialects()),
          [&overrides](const Dialect* dialect) {
            overrides.dialect = dialect;
            overrides.dialectNamed = true;
          });
}

/// Options of a render, apart from its files.
void addSceneCommand(CLI::App& app, SceneCommand& command) {
  RenderOptions& options = command.options;
  addOverrides(app, command);
  app.add_option("--error", options.error,
                 "adaptive sampling: stop where a pixel's standard error, 1 being white, is below "
                 "E; --spp is the maximum per pixel")
      ->type_name("E")
      ->check([](const std::string& text) {
        double error = 0.0;
        const bool fits = CLI::detail::lexical_cast(text, error) && error > 0.0 && error <= 1e6;
        return fits ? "" : fmt::format("expected a number above 0, at most 1e6, not \"{}\"", text);
      });
  addNames(app, "--layers", "layers of the EXR file: " + namesOf(layerRows(), ", "),
           namesIn(layerRows()), [&options](const Rows<LayerRow>& all) { options.layers = all; });
  addCrop(app, options.crop);
  addShard(app, options.shard);
  addDevice(app, command.vulkan);
  app.add_flag("--nori-compat", options.noriCompat,
               "as Nori: filter weights from a table, 8-bit pictures read as linear");
  addThreads(app, options.threads);
}

void addRender(CLI::App& app, RenderCommand& command) {
  app.add_option("SCENE.xml", command.scene, "Nori scene or test, or a picture, FILE.exr, to view")
      ->type_name("");
  addSceneCommand(app, command);
  app.add_option("-o,--output,--outfile", command.output,
                 "picture to write, with a .png of the same name")
      ->check(isNotEmpty())
      ->type_name("OUT.exr");
  app.add_flag("--reference", command.reference, "render in double precision on the CPU");
  app.add_flag("--resume", command.resume,
               "continue from OUT.state.exr if it exists, and write one to continue from");
  app.add_flag("--validate", command.vulkan.validate, "treat every validation message as an error");
  app.add_flag("--stats{-}", command.stats, "print statistics to stderr, or write them to a file")
      ->option_text("[=FILE.json]");
  app.add_option_function<std::string>(
         "--display-server",
         [&](const std::string& text) { command.displayServer = viewerAddress(text); },
         "show the picture in tev or HDRView while it renders")
      ->type_name("HOST:PORT");
  app.add_flag("-q,--quiet", command.quiet, "print nothing but warnings and errors");
  app.add_flag("--gui", command.gui, "show the picture in a window while it renders");
  app.add_flag_callback(
      "-b,--nogui,--no-gui", [&] { command.gui = false; },
      "no window, even with --gui; the default");
}

void addPlan(CLI::App& app, PlanCommand& command) {
  addScene(app, command.scene)->required();
  addSceneCommand(app, command);
  app.add_flag("--json", command.json, "print JSON");
}

void addCompare(CLI::App& app, CompareCommand& command) {
  app.add_option("A.exr", command.a, "picture")->type_name("")->required();
  app.add_option("B.exr", command.b, "reference")->type_name("")->required();
  app.add_option("--tolerance", command.tolerance,
                 "exit code 5 if the metric of a channel is beyond it");
  app.add_option("--metric", command.metric, "metric that the tolerance bounds")
      ->check(CLI::IsMember(metricNames()));
  app.add_option("--max-share", command.maxShare,
                 "exit code 5 if a larger share of the pixels is beyond the tolerance")
      ->check(CLI::Range(0.0, 1.0))
      ->needs(app.get_option("--tolerance"));
  app.add_flag("--noise", command.noise,
               "exit code 5 if noise does not explain the difference, by the variances that "
               "--layers variance writes")
      ->excludes(app.get_option("--tolerance"));
  app.add_option("--significance", command.limits.significance,
                 "of --noise: share of equal pictures that differ by chance")
      ->check(CLI::Range(1e-12, 0.5))
      ->needs(app.get_option("--noise"));
  app.add_option("--pass", command.limits.pass, "of --noise: share of the pixels that must agree")
      ->check(CLI::Range(0.0, 1.0))
      ->needs(app.get_option("--noise"));
  app.add_flag("--json", command.json, "print all figures as JSON");
  app.add_option("--out", command.out, "folder for difference.exr and difference.png")
      ->check(isNotEmpty())
      ->type_name("DIR");
}

void addMerge(CLI::App& app, MergeCommand& command) {
  app.add_option("PARTS.exr", command.parts, "all parts, which --shard wrote")
      ->type_name("")
      ->required();
  app.add_option("-o,--output,--outfile", command.output,
                 "picture to write, with a .png of the same name")
      ->check(isNotEmpty())
      ->type_name("OUT.exr")
      ->required();
}

void addExplain(CLI::App& app, ExplainCommand& command) {
  addScene(app, command.scene)->required();
  addSize(app, command.overrides.size, "size of the film in pixels");
  app.add_option("--seed", command.overrides.seed, "seed of the sampler");
  addDevice(app, command.vulkan);
}

void addView(CLI::App& app, ViewCommand& command) {
  app.add_option("A.exr", command.a, "picture")->type_name("")->required();
  app.add_option("B.exr", command.b, "picture to compare it with")->type_name("");
  app.footer(viewKeys());
}

void addChart(CLI::App& app, ChartCommand& command) {
  addScene(app, command.scene)->required();
  app.add_option("--out", command.out, "folder of the chart; default SCENE-chart beside the scene")
      ->check(isNotEmpty())
      ->type_name("DIR");
  addSize(app, command.size, "size of the film in pixels; default 256 wide");
  app.add_option("--device", command.device, "as for rendering");
  addThreads(app, command.threads);
  app.add_option("--runs", command.runs, "renders of each point; the median counts")
      ->check(CLI::Range(1U, 1000U));
  app.add_option("--spp", command.samples, "samples per pixel at most")
      ->check(CLI::Range(1U, kMaxSamples));
  app.add_option("--reference-spp", command.referenceSamples,
                 "samples per pixel of each half of the reference")
      ->check(CLI::Range(1U, kMaxSamples));
  app.add_option("--peer", command.peers,
                 "another renderer that takes laver's options; may be repeated")
      ->type_name("NAME COMMAND")
      ->type_size(2)
      ->expected(1, 1000);
  app.add_flag("-q,--quiet", command.quiet, "print nothing but warnings and errors");
}

void addTest(CLI::App& app, TestCommand& command) {
  app.add_option("FOLDER", command.folder, "folder of scenes and tests")->type_name("")->required();
  addDevice(app, command.vulkan);
  addThreads(app, command.threads);
  app.add_flag("--reference", command.reference, "render in double precision on the CPU");
  app.add_option("--jobs", command.jobs, "tests that run at once")->check(CLI::Range(1U, 1024U));
  app.add_option("--timeout", command.timeout, "seconds that a test may take")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--accept", command.accept,
               "write the expected pictures of tests that have none or fail");
  app.add_flag("--allow-skip", command.allowSkip, "without a Vulkan device, skip tests");
  app.add_option("--junit", command.junit, "JUnit XML file to write")
      ->check(isNotEmpty())
      ->type_name("FILE.xml");
  app.add_option("--html", command.html, "page with all pictures to write")
      ->check(isNotEmpty())
      ->type_name("FILE.html");
  app.footer(suite::help());
}

void addSchema(CLI::App& app, SchemaCommand& command) {
  app.add_flag("--json", command.json, "as JSON")
      ->excludes(app.add_flag("--markdown", command.markdown, "as tables of a Markdown document"));
}

/// Adds a subcommand; if it is given, it becomes the job.
template <class Command>
void addSubcommand(CLI::App& app, const char* name, const char* meaning,
                   void (*addOptions)(CLI::App&, Command&), Job& job) {
  const auto command = std::make_shared<Command>();
  CLI::App* const sub = app.add_subcommand(name, meaning);
  addOptions(*sub, *command);
  sub->callback([&job, command] { job = *command; });
}

void addDevices(CLI::App& app, DevicesCommand& command) {
  app.add_flag("--check", command.check,
               "render small scenes on each device by every traversal and compare them with the "
               "reference; exit code 5 if one is wrong");
}

}  // namespace

Job parse(int argc, const char* const* argv) {
  CLI::App app("Renders Nori scenes with Vulkan compute.", "laver");
  app.set_version_flag("--version", std::string("laver ") + LAVER_VERSION);
  RenderCommand render;
  addRender(app, render);
  Job job;
  addSubcommand(app, "compare", "Measures how a picture differs from another", addCompare, job);
  addSubcommand(app, "merge", "Joins the parts of a picture that --shard rendered", addMerge, job);
  addSubcommand(app, "explain", "Renders a scene and explains each difference from the reference",
                addExplain, job);
  addSubcommand(app, "view", "Shows one or two pictures in a window", addView, job);
  addSubcommand(app, "chart", "Draws speed against accuracy for every way to render a scene",
                addChart, job);
  addSubcommand(app, "test", "Compares the scenes of a folder with their expected pictures",
                addTest, job);
  addSubcommand(app, "devices", "Lists Vulkan devices", addDevices, job);
  addSubcommand(app, "plan", "Prints how a scene would be rendered, what is left out and why",
                addPlan, job);
  addSubcommand(app, "schema", "Lists everything that a scene file may contain", addSchema, job);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    const auto used = app.get_subcommands();
    throw Error(ExitCode::Usage, fmt::format("unexpected argument {}; see laver{} --help",
                                             app.remaining(true).front(),
                                             used.empty() ? "" : " " + used.front()->get_name()));
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() != 0) throw Error(ExitCode::Usage, error.what());
    std::ostringstream text;
    app.exit(error, text, text);
    return HelpCommand{text.str()};
  }
  if (!app.get_subcommands().empty()) return job;
  if (render.scene.empty()) throw Error(ExitCode::Usage, "no scene given; see laver --help");
  if (std::filesystem::path(render.scene).extension() == ".exr")
    return ViewCommand{render.scene, {}};
  return render;
}

ExitCode run(const HelpCommand& command) {
  std::cout << command.text;
  flushStandardOutput();
  return ExitCode::Ok;
}

}  // namespace laver
