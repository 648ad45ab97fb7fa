#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "render/film_state.h"
#include "render/options.h"
#include "render/rendered.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace laver {

/// Options of the Vulkan renderer.
struct VulkanOptions {
  std::string device;                 ///< argument of choosePhysicalDevice()
  bool validate = false;              ///< every validation message is an error
  std::string traversal;              ///< argument of traversalOf()
  std::uint64_t samplesInFlight = 0;  ///< for tests; 0: the renderer's choice
  bool wholeFilm = false;             ///< for tests: also traces pixels that see no geometry
  bool poisoned = false;              ///< for tests: samples are NaN until they are traced
  std::vector<std::string> general;   ///< for tests: parts of generalParts()
  bool keepsKernels = false;          ///< for tests: renders take kernels from earlier ones
};

/// Renders on a Vulkan device, which starts on another thread while the scene is loaded.
class Renderer {
 public:
  explicit Renderer(const VulkanOptions& options);
  ~Renderer();

  /// Renders the film or its crop, until an observer stops it. Fills `stats` except for loading and
  /// writing. Throws Error(Device) if no device could be started, for an exceeded limit, a lost
  /// device, or with `validate` the first message, and Error(Usage) for an unknown traversal.
  Rendered render(const Scene& scene, const RenderOptions& options, Stats& stats);

  /// The same, continuing from the sums in `state`, if any; the bits are those of one uninterrupted
  /// render. `state` is updated according to state.keep(). Throws Error(Usage) as
  /// FilmState::begin() does.
  Rendered render(const Scene& scene, const RenderOptions& options, FilmState& state, Stats& stats);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver
