#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "image/noise_test.h"
#include "render/options.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "show/connection.h"

// host/commands is laver's command line. cli.h parses the arguments into one of the structs below,
// and each subcommand is a function run() in its own file. Shared parts: loading scenes
// (scene_command.h), the files of a render (output.h, resume.h), observers of a render
// (observers.h), and the process (process.h). The rest of the host does not depend on this folder.
namespace laver {

struct DeviceInfo;

/// A scene and the options with which to render it.
struct SceneCommand {
  std::string scene;
  SceneOverrides overrides;
  RenderOptions options;
  VulkanOptions vulkan;
};

/// `laver SCENE.xml`.
struct RenderCommand : SceneCommand {
  std::string output;  ///< EXR; empty: beside the scene
  bool reference = false;
  bool resume = false;  ///< keep the sums, and continue from existing ones
  std::string stats;    ///< file of statistics; kToStderr: standard error; empty: none
  bool quiet = false;
  bool gui = false;                            ///< show the picture in a window
  std::optional<ViewerAddress> displayServer;  ///< of a viewer that shows the render in progress

  static constexpr const char* kToStderr = "-";
};

/// `laver plan SCENE.xml`.
struct PlanCommand : SceneCommand {
  bool json = false;
};

/// `laver compare A.exr B.exr`.
struct CompareCommand {
  std::string a, b;
  std::optional<double> tolerance;  ///< exceeding it means ExitCode::Different
  std::string metric = "max";       ///< that the tolerance bounds
  std::optional<double> maxShare;   ///< of pixels beyond the tolerance, which then bounds pixels
  bool json = false;
  std::string out;     ///< folder for pictures of the difference; empty: none
  bool noise = false;  ///< a test of whether noise explains the difference takes the metric's place
  NoiseLimits limits;  ///< of that test
};

/// `laver merge PARTS... -o OUT.exr`.
struct MergeCommand {
  std::vector<std::string> parts;  ///< files
  std::string output;
};

/// `laver explain SCENE.xml`.
struct ExplainCommand {
  std::string scene;
  SceneOverrides overrides;
  VulkanOptions vulkan;
};

/// `laver view A.exr B.exr`.
struct ViewCommand {
  std::string a, b;  ///< b may be empty
};

/// `laver chart SCENE.xml`.
struct ChartCommand {
  std::string scene;
  std::string out;                 ///< folder; empty: beside the scene
  std::optional<glm::ivec2> size;  ///< default: 256 pixels wide
  std::string device;
  unsigned threads = 0;
  std::size_t runs = 5;
  std::uint32_t samples = 256, referenceSamples = 1024;
  std::vector<std::string> peers;  ///< NAME COMMAND, one after the other
  bool quiet = false;
};

/// `laver test FOLDER`.
struct TestCommand {
  std::string folder;
  VulkanOptions vulkan;
  unsigned threads = 0;
  bool reference = false;
  std::size_t jobs = 1;     ///< tests that run at once
  double timeout = 600.0;   ///< seconds that each may take
  bool accept = false;      ///< write expected pictures
  bool allowSkip = false;   ///< without a device, tests are skipped
  std::string junit, html;  ///< files to write; empty: none
};

/// `laver devices`.
struct DevicesCommand {
  bool check = false;  ///< render small scenes on each
};

/// `laver schema`.
struct SchemaCommand {
  bool markdown = false;
  bool json = false;
};

/// `laver --help` and `laver --version`: a text to print.
struct HelpCommand {
  std::string text;
};

/// Throw Error. An interrupted render throws Error(Interrupted) or Error(Terminated) after writing
/// its partial result under another name.
ExitCode run(const RenderCommand& command);
/// Runs a file whose root is <test>; Different where a hypothesis is rejected.
ExitCode runTestFile(const RenderCommand& command);
ExitCode run(const PlanCommand& command);
ExitCode run(const CompareCommand& command);
ExitCode run(const MergeCommand& command);
ExitCode run(const ExplainCommand& command);
/// Throws Error(Device) if no window can be opened.
ExitCode run(const ViewCommand& command);
ExitCode run(const ChartCommand& command);
/// Different where a test fails.
ExitCode run(const TestCommand& command);
ExitCode run(const DevicesCommand& command);
ExitCode run(const SchemaCommand& command);
ExitCode run(const HelpCommand& command);

/// Aligned lines about a device: its properties, the limits that laver depends on, and why it is
/// rejected, if it is. `isDefault` means that laver selects it by default.
std::string describe(const DeviceInfo& device, std::size_t index, bool isDefault);

}  // namespace laver
