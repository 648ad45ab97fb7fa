#pragma once
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "render/device_scene.h"
#include "render/footprint.h"
#include "render/kernels.h"
#include "render/renderings.h"
#include "render/stats.h"
#include "render/work_list.h"

namespace laver {

/// The passes of a render on its device: each traces some samples of every pixel of a band, and
/// gathers them into the film.
class Passes {
 public:
  Passes(const Device& device, const SceneData& data, const RenderPlan& plan, const Scene& scene,
         const RenderOptions& options, Stats& stats);

  /// For tests: samples are NaN until they are traced.
  void poison() { onDevice_.poisonSamples(); }
  /// Takes kernels that were compiled for what begin() is called with next.
  void take(Kernels kernels);
  /// Makes the passes that follow those of a picture. Compiles its kernel, unless it was taken.
  void begin(const Rendering& picture, bool taken);
  /// The share of an area that the picture begun may show something in; the rest is black untraced.
  double seen(const Crop& area) const { return gatherable_.share(area); }
  /// From here on a pixel gets as many samples as the map says; null: as many as add() says.
  void use(const SampleMap* map) { map_ = map; }

  /// The film starts anew, or with the sums of some of its rows.
  void clearFilm();
  void setFilm(std::span<const std::byte> sums);
  /// The sums of a band's pixels, until the next pass.
  std::span<const std::byte> filmOf(const Crop& band);

  /// Adds samples [first, end) of the pixels of a band, calling passed(n) when n samples are in it;
  /// returns to which sample it came, less than `end` if an observer ended it.
  std::uint32_t add(const Crop& band, std::uint32_t first, std::uint32_t end,
                    const std::function<void(std::uint32_t)>& passed);
  /// The most samples that a pixel of a band gets: what the map says, or else `samples`.
  std::uint32_t mostOf(const Crop& band, std::uint32_t samples) const;
  /// One ray through the centre of each pixel, whose hits the film holds then; returns 1, or 0 if
  /// it was stopped before.
  std::uint32_t traceCentres(const Crop& band);

  /// What is traced of the film to reconstruct a band.
  glm::uvec4 regionAround(const Crop& band) const;
  /// New parameters for the passes that follow.
  void upload(const shared::Params& params) { onDevice_.upload(params); }
  std::uint64_t dropped() const { return status_.dropped; }
  void forgetDropped();

 private:
  /// Where cells have counts of their own in the present picture.
  bool mapped() const { return map_ != nullptr && constants_[shared::SPEC_ADAPTIVE] != 0; }
  void compileTrace();
  void tracePass(const shared::Pass& pass);
  void dispatchPass(shared::Pass pass);
  void dispatchSamples(VkCommandBuffer commands, shared::Pass pass) const;
  void gatherPass(shared::Pass pass);
  void planParts(const shared::Pass& pass);
  int apron() const { return static_cast<int>(data_.constants[shared::SPEC_APRON]); }
  void listWork(const shared::Pass& pass);
  void dispatchListed(VkCommandBuffer commands, const Kernel& kernel, shared::Pass pass,
                      const WorkRange& work) const;

  /// log2 of how many samples of a pixel are traced side by side.
  static constexpr std::array<std::uint32_t, 4> kShifts = {6, 4, 2, 0};

  const Device& device_;
  const SceneData& data_;
  const RenderPlan& plan_;
  const Scene& scene_;
  const RenderOptions& options_;
  Stats& stats_;
  DeviceScene onDevice_;
  std::optional<Kernel> trace_, gather_;
  std::string kernel_;
  SpecConstants constants_{};
  shared::Status status_{};
  bool filmIsClear_ = true;
  std::vector<std::byte> copy_;
  const Footprint footprint_;  ///< of the scene
  Footprint gatherable_;       ///< pixels that the present picture's samples may reach with a value
  std::vector<Crop> traced_, gathered_;  ///< what of the present band
  const SampleMap* map_ = nullptr;
  std::array<WorkRange, kShifts.size()> tracing_{};  ///< with a map only, as what follows
  WorkRange gathering_{};
};

}  // namespace laver
