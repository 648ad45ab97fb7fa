#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "image/image.h"
#include "render/film_state.h"
#include "render/options.h"
#include "render/rendered.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace laver {

/// Choices of the Vulkan renderer.
struct VulkanOptions {
  std::string device;                 ///< as choosePhysicalDevice takes it
  bool validate = false;              ///< every validation message is an error
  std::string traversal;              ///< as traversalOf() takes it
  std::uint64_t samplesInFlight = 0;  ///< for tests: 0 is the renderer's own choice
  bool wholeFilm = false;             ///< for tests: renders what sees nothing too
  bool poisoned = false;              ///< for tests: samples are NaN until they are traced
  std::uint32_t generic = 0;          ///< for tests: constants that generalise() makes generic
};

/// Renders on a Vulkan device, which starts on a thread of its own, beside the loading of a scene.
class Renderer {
 public:
  explicit Renderer(const VulkanOptions& options);
  ~Renderer();

  /// Renders the film or its crop, up to where an observer ends it. Throws
  /// Error(Device) where no device could be started, for a limit, a lost device, or, with
  /// `validate`, the first message, and Error(Usage) for an unknown traversal. Fills `stats` but
  /// for loading and writing.
  Rendered render(const Scene& scene, const RenderOptions& options, Stats& stats);

  /// The same, from the sums in `state` on, if there are some: the bits are those of a render in
  /// one go. `state` takes what its Keep says. Throws Error(Usage) as FilmState::begin does.
  Rendered render(const Scene& scene, const RenderOptions& options, FilmState& state, Stats& stats);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace laver
