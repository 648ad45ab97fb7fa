#pragma once
#include <array>
#include <future>
#include <optional>
#include <string>

#include "bvh/portions.h"
#include "render/coverage.h"
#include "render/device_scene.h"
#include "render/render_kernels.h"
#include "render/work_list.h"

namespace laver {

/// Work of a frame, for statistics.
struct FrameWork {
  std::uint32_t passes = 0;
  std::uint64_t samples = 0;
  double uploadSeconds = 0, compileSeconds = 0, traceSeconds = 0, gatherSeconds = 0;
  std::vector<ModuleSource> modules;  ///< sources of its kernels, in the order of compilation
  std::string fallback;  ///< why rays were traced in smaller steps; empty: they were not
};

/// The film on the device: traces passes of samples of a band and gathers them into the band's
/// sums.
class Frame {
 public:
  /// Uploads the scene, then waits for the first picture's kernels, which may be compiling
  /// meanwhile.
  Frame(const Device& device, const Packed& packed, const Choices& choices,
        std::future<Kernels> kernels);

  /// For tests: sets samples to NaN before they are traced.
  void poison() const { onDevice_.poisonSamples(); }
  /// Selects the picture of the following passes and compiles its kernel if necessary.
  void begin(const PictureChoice& picture);
  /// Share of an area in which the current picture may be nonzero; the rest stays black.
  double coverage(const Crop& area) const { return gatherable_.share(area); }
  /// Selects the sample counts of the following passes: from the map, or if null, from each pass.
  void use(const SampleMap* map) { map_ = map; }
  /// Sets the seed of the following passes.
  void seed(std::int64_t seed) const;

  /// Sets the film's sums to 0, or to those of some rows.
  void clearFilm();
  void setFilm(std::span<const std::byte> sums);
  /// The sums of a band's pixels, valid until the next pass.
  std::span<const std::byte> filmOf(const Crop& band);

  /// A pass over a band, with no samples yet.
  shared::Pass passOver(const Crop& band);
  /// A pass of one ray through the centre of each pixel of a band; it stores the hits in the film.
  shared::Pass passOverCentres(const Crop& band);
  /// Traces the pass's samples.
  void trace(const shared::Pass& pass);
  /// The pass's samples, valid until the next pass: one per slot, at (x, y) within its pixel.
  struct Traced {
    std::span<const glm::vec4> values;  ///< radiance, x
    std::span<const float> inY;         ///< y
    std::span<const Crop> gathered;     ///< pixels to which the samples contribute
  };
  Traced traced();
  /// Adds the pass's samples to the film's sums.
  void gather(const shared::Pass& pass);

  /// The pixels that are traced to reconstruct a band.
  glm::uvec4 regionAround(const Crop& band) const;
  /// The maximum number of samples per pixel of a band: from the map, or else `samples`.
  std::uint32_t maxSamples(const Crop& band, std::uint32_t samples) const;

  /// Samples dropped since the last forgetDropped(): negative or not finite.
  std::uint64_t dropped() const { return status_.dropped; }
  void forgetDropped();
  const FrameWork& work() const { return work_; }
  void countSamples(std::uint64_t samples) { work_.samples += samples; }
  /// Returns the number of samples counted so far, and resets it.
  std::uint64_t takeSampleCount() { return std::exchange(work_.samples, 0); }
  Traversal traversal() const { return traversal_; }

 private:
  bool mapped() const { return map_ != nullptr && picture_->key.adaptive; }
  int apron() const { return static_cast<int>(choices_.gather.apron); }
  void compileTrace(Traversal traversal);
  /// A dispatch of a kernel: its push constants and the number of workgroups.
  struct Dispatch {
    shared::Pass pass;
    std::array<std::uint32_t, 3> groups;
  };
  std::vector<Dispatch> tracing(shared::Pass pass) const;
  static Dispatch listed(shared::Pass pass, const WorkRange& work);
  void record(VkCommandBuffer commands, const Kernel& kernel, const Dispatch& dispatch) const;
  void dispatchLights(shared::Pass pass);

  // Of frame_portions.cpp.
  bool takesSmallerSteps();
  void dispatchPortions(const shared::Pass& pass);
  bool answerQueries(Dispatch dispatch);
  std::vector<Dispatch> split(const Dispatch& whole, std::uint32_t most) const;

  void planParts(const shared::Pass& pass);
  void listWork(const shared::Pass& pass);
  shared::Params paramsOf(const IntegratorUse& integrator) const;

  /// log2 of the samples per pixel that a workgroup traces side by side.
  static constexpr std::array<std::uint32_t, 4> kShifts = {6, 4, 2, 0};

  const Device& device_;
  const Packed& packed_;
  const Choices& choices_;
  FrameWork work_;
  DeviceScene onDevice_;
  Traversal traversal_;
  std::optional<Portions> portions_;  ///< set once walks of `lane` were cut short
  std::uint32_t queriesAtOnce_ = 1;   ///< by a dispatch, with the former
  const Coverage covered_;            ///< pixels that the scene covers
  Kernels kernels_;
  const PictureChoice* picture_ = nullptr;
  shared::Status status_{};
  bool filmIsClear_ = true;
  std::vector<std::byte> copy_, copyOfSamples_, copyOfY_;
  Coverage gatherable_;                  ///< pixels that the current picture's samples may affect
  std::vector<Crop> traced_, gathered_;  ///< parts of the current band
  const SampleMap* map_ = nullptr;
  std::array<WorkRange, kShifts.size()> tracing_{};  ///< these two only with a map
  WorkRange gathering_{};
};

}  // namespace laver
