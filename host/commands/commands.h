#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "core/error.h"
#include "display/connection.h"
#include "render/renderer.h"
#include "scene/render_options.h"
#include "scene/scene.h"

namespace laver {

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
  bool stats = false;
  std::string statsFile;
  bool quiet = false;
  std::optional<ViewerAddress> displayServer;  ///< of a viewer that shows the picture grow
};

/// `laver plan SCENE.xml`.
struct PlanCommand : SceneCommand {
  bool json = false;
};

/// `laver compare A.exr B.exr`, or `laver compare --explain SCENE.xml`.
struct CompareCommand {
  std::string a, b;
  double tolerance = 0.0;
  bool judged = false;         ///< a tolerance was given: beyond it is ExitCode::Different
  std::string metric = "max";  ///< what the tolerance bounds: max, p999, rmse or relmse
  std::string out;             ///< folder for pictures of the difference; empty: none
  std::string explain;         ///< a scene to render and hold against the reference; empty: none
  VulkanOptions vulkan;        ///< for `explain`
};

/// Throws what it cannot do; an interrupted render throws Error(Interrupted) or Error(Terminated)
/// after what there is has been written under another name.
ExitCode run(const RenderCommand& command);
ExitCode run(const CompareCommand& command);
ExitCode run(const PlanCommand& command);
/// `laver devices`.
ExitCode runDevices();
/// `laver schema`.
ExitCode runSchema(bool json);

/// What a command changes in its scene. What is rendered beside the scene's picture asks for
/// materials and lights too.
SceneOverrides overridesOf(const SceneCommand& command);

/// Throws Error(Usage) where a scene cannot be rendered with such options.
void checkOptions(const SceneCommand& command, const Scene& scene);

}  // namespace laver
