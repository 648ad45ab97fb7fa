#include "render/render.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "render/resolve.h"
#include "render/sample_map.h"
#include "render/stopwatch.h"
#include "render/variance.h"
#include "scene/layers.h"
#include "shared/slots.h"

namespace laver {
namespace {

/// The loop that is the renderer: picture by picture, band by band, pass by pass.
class Loop {
 public:
  Loop(Frame& frame, const RenderTask& task, FilmState& state, RenderTimes& times)
      : frame_(frame), task_(task), strips_(task.choices.strips), state_(state), times_(times) {}

  Rendered run() {
    std::vector<Image> parts;
    Reached ofFirst;
    bool whole = true;
    for (const PictureChoice& picture : task_.choices.pictures) {
      picture_ = &picture;
      task_.observers.beginPicture(parts.size(), task_.choices.pictures.size());
      const Crop core = task_.choices.core;
      image_ = blackImage(core.x1 - core.x0, rowsOf(strips_), picture.channels);
      Reached reached;
      if (whole) {
        frame_.begin(picture);
        if (parts.empty()) {
          if (asks(task_.options.layers, layers::variance)) beginVariances();
          times_.coverage = coverage();
          reached = renderFirst();
        } else {
          reached = renderFilm(strips_, wanted(), image_);
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

  /// Share of the pixels that the scene covers.
  double coverage() const {
    double rows = 0;
    for (const Strip& strip : strips_) rows += strip.rows() * frame_.coverage(strip.pixels);
    return rows / image_.height;
  }

  const SampleMap& mapOf(const Strip& band) const {
    return maps_[static_cast<std::size_t>(&stripAt(strips_, band.row) - strips_.data())];
  }

  /// Samples per pixel of the current picture.
  std::uint32_t wanted() const {
    return picture_->centres ? 1 : !maps_.empty() ? maxSamplesOf(sampler()) : sampler().sampleCount;
  }

  /// Renders the main picture.
  Reached renderFirst() {
    if (task_.options.error == 0.0) return renderKept();
    maps_ = runPilots();
    if (maps_.empty()) return {};
    const Reached reached = renderFilm(strips_, wanted(), image_);
    times_.adaptive.describe(maps_, strips_, wanted());
    return reached;
  }

  /// Renders the picture, continuing from the sums in the state.
  Reached renderKept() {
    Reached reached;
    bool stopped = false;
    for (int row = 0, rows = 0; row < image_.height; row += rows) {
      const Strip& strip = stripAt(strips_, row);
      rows = state_.equalRows(row, std::min(strip.row + strip.rows() - row, bandRows()));
      std::uint32_t samples = state_.samples[static_cast<std::size_t>(row)];
      if (stopped || samples == wanted()) {
        if (samples != 0) resolve(state_.bytes(row, rows), row, task_.options.threads, image_);
      } else {
        samples = renderRows(strip.part(row, rows), samples);
        if (samples != wanted() && state_.keep() == FilmState::Keep::WhenEnded)
          state_.takeFinished(image_, row, wanted());
        stopped = samples != wanted();
      }
      reached.addRows(rows, samples, wanted());
    }
    return reached;
  }

  /// Renders a band of the picture from `had` to all samples per pixel or until the render is
  /// stopped. Returns the number of samples per pixel.
  std::uint32_t renderRows(const Strip& band, std::uint32_t had) {
    if (had != 0)
      frame_.setFilm(state_.bytes(band.row, band.rows()));
    else
      frame_.clearFilm();
    // Each group of GATHER_SAMPLES must be summed in one pass, however often the render is resumed.
    const bool always = state_.keep() == FilmState::Keep::Always;
    const std::uint32_t whole = always ? wanted() - wanted() % shared::GATHER_SAMPLES : wanted();
    std::uint32_t has = addSamples(band, {had, whole, wanted()});
    if (has != 0 && (always || (has != wanted() && state_.keep() == FilmState::Keep::WhenEnded)))
      state_.take(band.row, band.rows(), frame_.filmOf(band.pixels), has);
    if (has == whole && has != wanted()) has = addSamples(band, {whole, wanted(), wanted()});
    if (has != 0) showBand(band, image_);
    return has;
  }

  /// Renders `samples` per pixel, or as many as the map has.
  Reached renderFilm(const std::vector<Strip>& strips, std::uint32_t samples, Image& image) {
    Reached reached;
    for (const Strip& band : bandsIn(strips, bandRows())) {
      if (!maps_.empty()) frame_.use(&mapOf(band));
      const std::uint32_t has =
          picture_->centres ? traceCentres(band.pixels) : fillBand(band, samples);
      if (has == 0) break;
      reached.addRows(band.rows(), has, samples);
      showBand(band, image);
      if (has != samples) break;
    }
    return reached;
  }

  int bandRows() const { return static_cast<int>(task_.choices.tiling.bandRows); }

  std::uint32_t fillBand(const Strip& band, std::uint32_t samples) {
    frame_.clearFilm();
    const std::uint32_t max = frame_.maxSamples(band.pixels, samples);
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
  std::uint32_t addSamples(const Strip& band, const Span& span) {
    shared::Pass pass = frame_.passOver(band.pixels);
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
    frame_.countSamples(!maps_.empty() && picture_->key.adaptive
                            ? mapOf(band).samplesOf(band.pixels, done)
                            : std::uint64_t{pass.core.z} * pass.core.w * (done - span.first));
    return done;
  }

  void beginVariances() {
    variances_.emplace(strips_,
                       reference::FilterWeights(task_.scene.filter, task_.options.noriCompat),
                       task_.options.threads);
  }

  void addVariances(const shared::Pass& pass) {
    const Frame::Traced traced = frame_.traced();
    const glm::uvec4 region = pass.region;
    const auto at = [&](int x, int y, std::uint32_t s) -> PixelVariances::Sample {
      const std::uint32_t slot =
          shared::slotOf(pass.sampleCount, region, static_cast<std::uint32_t>(x) - region.x,
                         static_cast<std::uint32_t>(y) - region.y, s);
      const glm::vec4 value = traced.values[slot];
      return {{value.w, traced.inY[slot]}, glm::dvec3(value), value.w != shared::DROPPED};
    };
    for (const Crop& part : traced.gathered)
      variances_->add(part, cropOf(region), pass.sampleCount, at);
  }

  /// Reports that a band has n of its samples.
  void passDone(const Strip& band, std::uint32_t n, std::uint32_t of) {
    if (pilots()) return;
    const double share = static_cast<double>(n) / of;
    task_.observers.progress((band.row + share * band.rows()) / image_.height,
                             frame_.work().samples);
    if (n < of && task_.observers.due()) resolveBand(band, image_);
  }

  bool pilots() const { return task_.options.error != 0.0 && maps_.empty(); }

  void showBand(const Strip& band, Image& image) {
    resolveBand(band, image);
    ++times_.bands;
  }

  /// Resolves the sums of a band of a picture and reports the rows to the observers.
  void resolveBand(const Strip& band, Image& image) {
    task_.observers.show([&] {
      const Stopwatch watch(times_.readBackSeconds);
      const auto film = frame_.filmOf(band.pixels);
      if (picture_->centres)
        resolveCentres(film, band.row, {task_.scene, task_.packed}, task_.options, image);
      else
        resolve(film, band.row, task_.options.threads, image);
      if (!pilots()) task_.observers.rowsChanged(image, band.row, band.row + band.rows());
    });
  }

  /// Decides the counts of each strip. None if stopped.
  std::vector<SampleMap> runPilots() {
    std::vector<SampleMap> maps;
    for (const Strip& strip : strips_) {
      const Crop region = cropOf(frame_.regionAround(strip.pixels));
      const Camera& camera = task_.scene.camera;
      std::optional<SampleMap> map = runPilots(pilotArea(region, camera.width, camera.height));
      if (!map) return {};
      maps.push_back(std::move(*map));
    }
    frame_.seed(sampler().seed);
    frame_.forgetDropped();
    times_.adaptive.pilotSamples = frame_.takeSampleCount();
    return maps;
  }

  /// Renders pilots, pictures of one sample per pixel that cover everything that some counts depend
  /// on, and decides the counts. None if stopped.
  std::optional<SampleMap> runPilots(const Crop& area) {
    const SampleMap one(cropOf(frame_.regionAround(area)), 1);
    frame_.use(&one);
    std::vector<Image> pilots;
    for (int i = 0; i < pilotCount(task_.scene); ++i) {
      frame_.seed(pilotSeed(sampler().seed, i));
      pilots.push_back(rgbImage(area.x1 - area.x0, area.y1 - area.y0));
      if (renderFilm({{area, 0}}, 1, pilots.back()).wholeRows != pilots.back().height) return {};
    }
    return decideSamples(pilots, area, task_.options.error, maxSamplesOf(sampler()),
                         task_.options.threads);
  }

  Image samplesLayer(const Image& picture, const Reached& reached) const {
    if (!maps_.empty()) return times_.adaptive.samples;
    Image image = blackImage(picture.width, picture.height, {"samples"});
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        image.at(x, y, 0) = static_cast<float>(reached.samplesIn(y, sampler().sampleCount));
    return image;
  }

  Frame& frame_;
  const RenderTask& task_;
  const std::vector<Strip>& strips_;
  FilmState& state_;
  RenderTimes& times_;
  const PictureChoice* picture_ = nullptr;
  Image image_;
  std::vector<SampleMap> maps_;  ///< of the strips, with adaptive sampling after the pilots
  std::optional<PixelVariances> variances_;  ///< of the first picture
};

}  // namespace

Rendered renderLoop(Frame& frame, const RenderTask& task, FilmState& state, RenderTimes& times) {
  return Loop(frame, task, state, times).run();
}

}  // namespace laver
