#include "render/render.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "render/resolve.h"
#include "render/sample_map.h"
#include "render/stopwatch.h"
#include "render/variance.h"
#include "scene/layers.h"

namespace laver {
namespace {

/// The loop that is the renderer: picture by picture, band by band, pass by pass.
class Loop {
 public:
  Loop(Frame& frame, const RenderTask& task, FilmState& state, RenderTimes& times)
      : frame_(frame), task_(task), core_(task.choices.core), state_(state), times_(times) {}

  Rendered run() {
    std::vector<Image> parts;
    Reached ofFirst;
    bool whole = true;
    for (const PictureChoice& picture : task_.choices.pictures) {
      picture_ = &picture;
      task_.observers.beginPicture(parts.size(), task_.choices.pictures.size());
      image_ = blackImage(core_.x1 - core_.x0, core_.y1 - core_.y0, picture.channels);
      Reached reached;
      if (whole) {
        frame_.begin(picture);
        if (parts.empty()) {
          if (asks(task_.options.layers, layers::variance)) beginVariances();
          times_.coverage = frame_.coverage(core_);
          reached = renderFirst();
        } else {
          reached = renderFilm(core_, wanted(), image_);
        }
        whole = reached.wholeRows == image_.height;
      }
      if (parts.empty())
        ofFirst = reached;
      else if (!whole)
        ++ofFirst.unfinished;
      parts.push_back(std::move(image_));
    }
    state_.dropped += frame_.dropped();
    if (asks(task_.options.layers, layers::samples))
      parts.push_back(samplesLayer(parts.front(), ofFirst));
    if (variances_) parts.push_back(variances_->image());
    return {joined(std::move(parts)), ofFirst, state_.dropped};
  }

 private:
  const Sampler& sampler() const { return task_.scene.sampler; }

  /// Samples per pixel of the current picture.
  std::uint32_t wanted() const {
    return picture_->centres ? 1 : map_ ? maxSamplesOf(sampler()) : sampler().sampleCount;
  }

  /// Renders the main picture.
  Reached renderFirst() {
    if (task_.options.error == 0.0) return renderKept();
    map_ = runPilots();
    if (!map_) return {};
    frame_.use(&*map_);
    const Reached reached = renderFilm(core_, wanted(), image_);
    times_.adaptive.describe(*map_, core_, wanted());
    return reached;
  }

  /// Renders the picture, continuing from the sums in the state.
  Reached renderKept() {
    Reached reached;
    bool stopped = false;
    for (int row = 0, rows = 0; row < image_.height; row += rows) {
      rows = state_.equalRows(
          row, std::min(image_.height - row, static_cast<int>(task_.choices.tiling.bandRows)));
      std::uint32_t samples = state_.samples[static_cast<std::size_t>(row)];
      if (stopped || samples == wanted()) {
        if (samples != 0) resolve(state_.bytes(row, rows), row, task_.options.threads, image_);
      } else {
        samples = renderRows(row, rows, samples);
        if (samples != wanted() && state_.keep() == FilmState::Keep::WhenEnded)
          state_.takeFinished(image_, row, wanted());
        stopped = samples != wanted();
      }
      reached.addRows(rows, samples, wanted());
    }
    return reached;
  }

  /// Renders rows of the picture, which fit into a band, from `had` to all samples per pixel or
  /// until the render is stopped. Returns the number of samples per pixel.
  std::uint32_t renderRows(int row, int rows, std::uint32_t had) {
    const Crop band{core_.x0, core_.y0 + row, core_.x1, core_.y0 + row + rows};
    if (had != 0)
      frame_.setFilm(state_.bytes(row, rows));
    else
      frame_.clearFilm();
    // Each group of GATHER_SAMPLES must be summed in one pass, however often the render is resumed.
    const bool always = state_.keep() == FilmState::Keep::Always;
    const std::uint32_t whole = always ? wanted() - wanted() % shared::GATHER_SAMPLES : wanted();
    std::uint32_t has = addSamples(band, {had, whole, wanted()});
    if (has != 0 && (always || (has != wanted() && state_.keep() == FilmState::Keep::WhenEnded)))
      state_.take(row, rows, frame_.filmOf(band), has);
    if (has == whole && has != wanted()) has = addSamples(band, {whole, wanted(), wanted()});
    if (has != 0) showBand(band, core_, image_);
    return has;
  }

  /// Renders `samples` per pixel, or as many as the map has.
  Reached renderFilm(Crop core, std::uint32_t samples, Image& image) {
    Reached reached;
    const int rows = static_cast<int>(task_.choices.tiling.bandRows);
    for (int y = core.y0; y < core.y1; y += rows) {
      const Crop band{core.x0, y, core.x1, std::min(core.y1, y + rows)};
      const std::uint32_t has = picture_->centres ? traceCentres(band) : fillBand(band, samples);
      if (has == 0) break;
      reached.addRows(band.y1 - band.y0, has, samples);
      showBand(band, core, image);
      if (has != samples) break;
    }
    return reached;
  }

  std::uint32_t fillBand(const Crop& band, std::uint32_t samples) {
    frame_.clearFilm();
    const std::uint32_t max = frame_.maxSamples(band, samples);
    const std::uint32_t has = addSamples(band, {0, max, max});
    return has == max ? samples : has;
  }

  std::uint32_t traceCentres(const Crop& band) {
    if (task_.observers.stop()) return 0;
    frame_.trace(frame_.passOverCentres(band));
    return 1;
  }

  /// Samples [first, end) per pixel of a band whose final count is `of`.
  struct Span {
    std::uint32_t first, end, of;
  };

  /// The passes: traces samples and adds them to the film. Returns the number of samples per pixel,
  /// less than span.end if an observer stopped it.
  std::uint32_t addSamples(const Crop& band, const Span& span) {
    shared::Pass pass = frame_.passOver(band);
    std::uint32_t done = span.first;
    while (done < span.end && !task_.observers.stop()) {
      pass.firstSample = done;
      pass.sampleCount = std::min(task_.choices.tiling.samplesPerPass, span.end - done);
      frame_.trace(pass);
      if (variances_ && picture_ == &task_.choices.pictures.front()) addVariances(pass);
      frame_.gather(pass);
      done += pass.sampleCount;
      passDone(band, done, span.of);
    }
    frame_.countSamples(map_ && picture_->key.adaptive
                            ? map_->samplesOf(band, done)
                            : std::uint64_t{pass.core.z} * pass.core.w * (done - span.first));
    return done;
  }

  void beginVariances() {
    variances_.emplace(core_,
                       reference::FilterWeights(task_.scene.filter, task_.options.noriCompat),
                       task_.options.threads);
  }

  /// The slots are those of sampleSlot() in shaders/resources.glsl.
  void addVariances(const shared::Pass& pass) {
    const Frame::Traced traced = frame_.traced();
    const glm::uvec4 region = pass.region;
    const std::size_t perRow = (region.z + shared::SLOT_COLUMNS - 1) / shared::SLOT_COLUMNS;
    const std::size_t perBlock =
        std::size_t{std::min(pass.sampleCount, shared::GATHER_SAMPLES)} * shared::SLOT_COLUMNS;
    const auto at = [&](int x, int y, std::uint32_t s) -> PixelVariances::Sample {
      const std::size_t column = static_cast<std::size_t>(x) - region.x;
      const std::size_t row = std::size_t{s / shared::GATHER_SAMPLES} * region.w +
                              static_cast<std::size_t>(y) - region.y;
      const std::size_t slot = (row * perRow + column / shared::SLOT_COLUMNS) * perBlock +
                               std::size_t{s % shared::GATHER_SAMPLES} * shared::SLOT_COLUMNS +
                               column % shared::SLOT_COLUMNS;
      const glm::vec4 value = traced.values[slot];
      return {{value.w, traced.inY[slot]}, glm::dvec3(value), value.w != shared::DROPPED};
    };
    for (const Crop& part : traced.gathered)
      variances_->add(part, cropOf(region), pass.sampleCount, at);
  }

  /// Reports that a band has n of its samples.
  void passDone(const Crop& band, std::uint32_t n, std::uint32_t of) {
    if (pilots()) return;
    const double share = static_cast<double>(n) / of;
    task_.observers.progress(
        (band.y0 - core_.y0 + share * (band.y1 - band.y0)) / (core_.y1 - core_.y0),
        frame_.work().samples);
    if (n < of && task_.observers.due()) resolveBand(band, core_, image_);
  }

  bool pilots() const { return task_.options.error != 0.0 && !map_; }

  void showBand(const Crop& band, const Crop& core, Image& image) {
    resolveBand(band, core, image);
    ++times_.bands;
  }

  /// Resolves the sums of a band of a picture of `core` and reports the rows to the observers.
  void resolveBand(const Crop& band, const Crop& core, Image& image) {
    task_.observers.show([&] {
      const Stopwatch watch(times_.readBackSeconds);
      const auto film = frame_.filmOf(band);
      if (picture_->centres)
        resolveCentres(film, band.y0 - core.y0, {task_.scene, task_.packed}, task_.options, image);
      else
        resolve(film, band.y0 - core.y0, task_.options.threads, image);
      if (!pilots()) task_.observers.rowsChanged(image, band.y0 - core.y0, band.y1 - core.y0);
    });
  }

  /// Renders pilots, pictures of one sample per pixel that cover everything that the counts of the
  /// core depend on, and decides the counts. None if stopped.
  std::optional<SampleMap> runPilots() {
    const Crop area = task_.choices.tiling.planned;
    const SampleMap one(cropOf(frame_.regionAround(area)), 1);
    frame_.use(&one);
    std::vector<Image> pilots;
    for (int i = 0; i < kPilots; ++i) {
      frame_.seed(pilotSeed(sampler().seed, i));
      pilots.push_back(rgbImage(area.x1 - area.x0, area.y1 - area.y0));
      if (renderFilm(area, 1, pilots.back()).wholeRows != pilots.back().height) return {};
    }
    frame_.seed(sampler().seed);
    frame_.forgetDropped();
    times_.adaptive.pilotSamples = frame_.takeSampleCount();
    return decideSamples(pilots, area, task_.options.error, maxSamplesOf(sampler()),
                         task_.options.threads);
  }

  Image samplesLayer(const Image& picture, const Reached& reached) const {
    if (map_) return times_.adaptive.samples;
    Image image = blackImage(picture.width, picture.height, {"samples"});
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        image.at(x, y, 0) = static_cast<float>(reached.samplesIn(y, sampler().sampleCount));
    return image;
  }

  Frame& frame_;
  const RenderTask& task_;
  const Crop core_;
  FilmState& state_;
  RenderTimes& times_;
  const PictureChoice* picture_ = nullptr;
  Image image_;
  std::optional<SampleMap> map_;             ///< of adaptive sampling, after the pilots
  std::optional<PixelVariances> variances_;  ///< of the first picture
};

}  // namespace

Rendered renderLoop(Frame& frame, const RenderTask& task, FilmState& state, RenderTimes& times) {
  return Loop(frame, task, state, times).run();
}

}  // namespace laver
