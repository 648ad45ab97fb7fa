#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "render/options.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "show/connection.h"

// host/commands is laver's command line: cli.h turns arguments into one of the structs below, and
// each subcommand is a function run() in a file of its own, which the rest of the host knows
// nothing of. What they share: scenes (scene_command.h), files of a render (output.h, resume.h),
// observers of a render (observers.h), and the process (process.h).
namespace laver {

struct DeviceInfo;

/// A scene and how it is to be rendered.
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
  bool resume = false;  ///< keep the sums and go on from those that are there
  std::string stats;    ///< file of figures; kToStderr: standard error; empty: none
  bool quiet = false;
  bool gui = false;                            ///< show the picture in a window
  std::optional<ViewerAddress> displayServer;  ///< of a viewer that shows the picture grow

  static constexpr const char* kToStderr = "-";
};

/// `laver plan SCENE.xml`.
struct PlanCommand : SceneCommand {
  bool json = false;
};

/// `laver compare A.exr B.exr`.
struct CompareCommand {
  std::string a, b;
  std::optional<double> tolerance;  ///< beyond it is ExitCode::Different
  std::string metric = "max";       ///< what the tolerance bounds: max, p999, rmse or relmse
  std::string out;                  ///< folder for pictures of the difference; empty: none
};

/// `laver explain SCENE.xml`.
struct ExplainCommand {
  std::string scene;
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

/// `laver devices`.
struct DevicesCommand {};

/// `laver schema`.
struct SchemaCommand {
  bool markdown = false;
  bool json = false;
};

/// `laver --help` and `laver --version`: a text to print.
struct HelpCommand {
  std::string text;
};

/// Throws what it cannot do; an interrupted render throws Error(Interrupted) or Error(Terminated)
/// after what there is has been written under another name.
ExitCode run(const RenderCommand& command);
ExitCode run(const PlanCommand& command);
ExitCode run(const CompareCommand& command);
ExitCode run(const ExplainCommand& command);
/// Throws Error(Device) where there can be no window.
ExitCode run(const ViewCommand& command);
ExitCode run(const ChartCommand& command);
ExitCode run(const DevicesCommand& command);
ExitCode run(const SchemaCommand& command);
ExitCode run(const HelpCommand& command);

/// Aligned lines about a device: what it is, the limits laver depends on, and why it cannot be
/// used, if it cannot. `isDefault` says whether laver takes it unasked.
std::string describe(const DeviceInfo& device, std::size_t index, bool isDefault);

}  // namespace laver
