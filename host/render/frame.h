#pragma once
#include <array>
#include <future>
#include <string>

#include "render/coverage.h"
#include "render/device_scene.h"
#include "render/render_kernels.h"
#include "render/work_list.h"

namespace laver {

/// What a frame did, for statistics.
struct FrameWork {
  std::uint32_t passes = 0;
  std::uint64_t samples = 0;
  double uploadSeconds = 0, compileSeconds = 0, traceSeconds = 0, gatherSeconds = 0;
  std::vector<ModuleSource> modules;  ///< of its kernels, in the order of compiling
  std::string fallback;  ///< why rays were traced one by one in the end; empty: they were not
};

/// The film on its device: traces passes of samples of a band and gathers them into the band's
/// sums.
class Frame {
 public:
  /// Uploads; then takes the first picture's kernels, which may still be compiled meanwhile.
  Frame(const Device& device, const Packed& packed, const Choices& choices,
        std::future<Kernels> kernels);

  /// For tests: samples are NaN until they are traced.
  void poison() const { onDevice_.poisonSamples(); }
  /// The passes that follow are those of a picture. Compiles its kernel unless it is there.
  void begin(const PictureChoice& picture);
  /// The share of an area that the present picture may show something in; the rest stays black.
  double coverage(const Crop& area) const { return gatherable_.share(area); }
  /// From here on a pixel gets as many samples as the map says; null: as many as passes say.
  void use(const SampleMap* map) { map_ = map; }
  /// The seed of the passes that follow.
  void seed(std::int64_t seed) const;

  /// The film starts anew, or with the sums of some of its rows.
  void clearFilm();
  void setFilm(std::span<const std::byte> sums);
  /// The sums of a band's pixels, until the next pass.
  std::span<const std::byte> filmOf(const Crop& band);

  /// A pass over a band, without its samples.
  shared::Pass passOver(const Crop& band);
  /// One ray through the centre of each pixel of a band, whose hits the film holds then.
  shared::Pass passOverCentres(const Crop& band);
  /// Traces the pass's samples.
  void trace(const shared::Pass& pass);
  /// Adds them to the film's sums.
  void gather(const shared::Pass& pass);

  /// What is traced of the film to reconstruct a band.
  glm::uvec4 regionAround(const Crop& band) const;
  /// The most samples that a pixel of a band gets: what the map says, or else `samples`.
  std::uint32_t maxSamples(const Crop& band, std::uint32_t samples) const;

  /// Samples left out since the last forgetDropped(): negative or not finite.
  std::uint64_t dropped() const { return status_.dropped; }
  void forgetDropped();
  const FrameWork& work() const { return work_; }
  void countSamples(std::uint64_t samples) { work_.samples += samples; }
  /// The samples counted so far, which count no more.
  std::uint64_t takeSampleCount() { return std::exchange(work_.samples, 0); }
  Traversal traversal() const { return traversal_; }

 private:
  bool mapped() const { return map_ != nullptr && picture_->key.adaptive; }
  int apron() const { return static_cast<int>(choices_.gather.apron); }
  void compileTrace(Traversal traversal);
  void dispatchLights(shared::Pass pass);
  void dispatchSamples(VkCommandBuffer commands, shared::Pass pass) const;
  void dispatchListed(VkCommandBuffer commands, const Kernel& kernel, shared::Pass pass,
                      const WorkRange& work) const;
  void planParts(const shared::Pass& pass);
  void listWork(const shared::Pass& pass);
  shared::Params paramsOf(const IntegratorUse& integrator) const;

  /// log2 of how many samples of a pixel are traced side by side.
  static constexpr std::array<std::uint32_t, 4> kShifts = {6, 4, 2, 0};

  const Device& device_;
  const Packed& packed_;
  const Choices& choices_;
  FrameWork work_;
  DeviceScene onDevice_;
  Traversal traversal_;
  const Coverage covered_;  ///< by the scene
  Kernels kernels_;
  const PictureChoice* picture_ = nullptr;
  shared::Status status_{};
  bool filmIsClear_ = true;
  std::vector<std::byte> copy_;
  Coverage gatherable_;  ///< pixels that the present picture's samples may reach with a value
  std::vector<Crop> traced_, gathered_;  ///< of the present band
  const SampleMap* map_ = nullptr;
  std::array<WorkRange, kShifts.size()> tracing_{};  ///< with a map only, as what follows
  WorkRange gathering_{};
};

}  // namespace laver
