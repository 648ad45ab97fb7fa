#include "render/render_pictures.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "render/resolve.h"
#include "render/sampler_data.h"
#include "render/stopwatch.h"

namespace laver {
namespace {

class Render {
 public:
  Render(Passes& passes, const Film& film, FilmState& state, Stats& stats)
      : passes_(passes),
        data_(film.data),
        plan_(film.plan),
        scene_(film.scene),
        options_(film.options),
        core_(film.core),
        observers_(film.observers),
        state_(state),
        stats_(stats) {}

  Rendered run(std::vector<Rendering> pictures) {
    std::vector<Image> parts;
    Reached ofFirst;
    bool whole = true;
    for (Rendering& picture : pictures) {
      const SpecConstants guess = picture.constants;
      requireStack(picture.constants, data_.bvh.stack);
      picture_ = &picture;
      observers_.beginPicture(parts.size(), pictures.size());
      image_ = blackImage(core_.x1 - core_.x0, core_.y1 - core_.y0, picture.channels);
      const bool first = parts.empty();
      Reached reached;
      if (whole) {
        passes_.begin(picture, first && guess == picture.constants);
        if (first) {
          stats_.seen = passes_.seen(core_);
          renderFirst(reached);
        } else {
          renderFilm(core_, wantedOf(picture), image_, reached);
        }
        whole = reached.wholeRows == image_.height;
      }
      if (first)
        ofFirst = reached;
      else if (!whole)
        ++ofFirst.unfinished;
      parts.push_back(std::move(image_));
    }
    state_.dropped += passes_.dropped();
    stats_.droppedSamples = state_.dropped;
    if (asks(options_.layers, Layer::Samples))
      parts.push_back(samplesLayer(parts.front(), ofFirst));
    return {joined(std::move(parts)), ofFirst, state_.dropped};
  }

 private:
  /// The scene's own picture.
  void renderFirst(Reached& reached) {
    if (options_.error == 0.0) return renderKept(reached);
    map_ = runPilots();
    if (!map_) return;
    passes_.use(&*map_);
    renderFilm(core_, mostOf(scene_.sampler), image_, reached);
    stats_.adaptive.describe(*map_, core_, mostOf(scene_.sampler));
  }

  std::uint32_t wantedOf(const Rendering& picture) const {
    return picture.centres ? 1 : map_ ? mostOf(scene_.sampler) : scene_.sampler.sampleCount;
  }

  /// All samples of the picture, from what its state holds on.
  void renderKept(Reached& reached) {
    const int height = image_.height;
    const std::uint32_t wanted = scene_.sampler.sampleCount;
    bool ended = false;
    for (int row = 0, rows = 0; row < height; row += rows) {
      rows = state_.alike(row, std::min(height - row, static_cast<int>(plan_.bandRows)));
      std::uint32_t samples = state_.samples[static_cast<std::size_t>(row)];
      if (ended || samples == wanted) {
        if (samples != 0) resolve(state_.bytes(row, rows), row, image_, options_.threads);
      } else {
        samples = renderRows(row, rows, samples);
        if (samples != wanted && state_.keep() == FilmState::Keep::WhenEnded)
          state_.takeFinished(image_, row, wanted);
        ended = samples != wanted;
      }
      reached.addRows(rows, samples, wanted);
    }
  }

  /// Brings rows of the picture, which fit into a band, from `had` to all samples a pixel, or to
  /// where the render is ended; returns how many they have.
  std::uint32_t renderRows(int row, int rows, std::uint32_t had) {
    const Crop band{core_.x0, core_.y0 + row, core_.x1, core_.y0 + row + rows};
    if (had != 0)
      passes_.setFilm(state_.bytes(row, rows));
    else
      passes_.clearFilm();
    const std::uint32_t wanted = scene_.sampler.sampleCount;
    const auto passed = [&](std::uint32_t n) { passDone(band, n, wanted); };
    // Samples that are summed plainly are summed together, however often the render goes on.
    const bool always = state_.keep() == FilmState::Keep::Always;
    const std::uint32_t whole = always ? wanted - wanted % shared::GATHER_SAMPLES : wanted;
    std::uint32_t has = passes_.add(band, had, whole, passed);
    if (has != 0 && (always || (has != wanted && state_.keep() == FilmState::Keep::WhenEnded)))
      state_.take(row, rows, passes_.filmOf(band), has);
    if (has == whole && has != wanted) has = passes_.add(band, whole, wanted, passed);
    if (has == 0) return 0;
    showBand(band, core_, image_);
    return has;
  }

  /// Pictures of one sample a pixel of all that the counts of the core's samples depend on. None if
  /// stopped.
  std::optional<SampleMap> runPilots() {
    const Crop area = plan_.core;
    const SampleMap one(cropOf(passes_.regionAround(area)), 1);
    passes_.use(&one);
    std::vector<Image> pilots;
    shared::Params params = data_.params;
    for (int i = 0; i < kPilots; ++i) {
      packSeed(pilotSeed(scene_.sampler.seed, i), params);
      passes_.upload(params);
      pilots.push_back(rgbImage(area.x1 - area.x0, area.y1 - area.y0));
      Reached reached;
      renderFilm(area, 1, pilots.back(), reached);
      if (reached.wholeRows != pilots.back().height) return {};
    }
    passes_.upload(data_.params);
    passes_.forgetDropped();
    stats_.adaptive.pilotSamples = std::exchange(stats_.samples, 0);
    return decideSamples(pilots, area, options_.error, mostOf(scene_.sampler), options_.threads);
  }

  /// `samples` of every pixel, or as many of them as the map says.
  void renderFilm(Crop core, std::uint32_t samples, Image& image, Reached& reached) {
    for (int y = core.y0; y < core.y1; y += static_cast<int>(plan_.bandRows)) {
      const Crop band{core.x0, y, core.x1, std::min(core.y1, y + static_cast<int>(plan_.bandRows))};
      const std::uint32_t has =
          picture_->centres ? passes_.traceCentres(band) : fillBand(band, samples);
      if (has == 0) break;
      reached.addRows(band.y1 - band.y0, has, samples);
      showBand(band, core, image);
      if (has != samples) break;
    }
  }

  std::uint32_t fillBand(const Crop& band, std::uint32_t samples) {
    passes_.clearFilm();
    const std::uint32_t most = passes_.mostOf(band, samples);
    const std::uint32_t has =
        passes_.add(band, 0, most, [&](std::uint32_t n) { passDone(band, n, most); });
    return has == most ? samples : has;
  }

  bool pilots() const { return options_.error != 0.0 && !map_; }

  /// Resolves what a band of a picture of `core` has, and shows it to the observers.
  void resolveBand(const Crop& band, const Crop& core, Image& image) {
    observers_.show([&] {
      const Stopwatch watch(stats_.seconds.readBack);
      const auto film = passes_.filmOf(band);
      if (picture_->centres)
        resolveCentres(film, band.y0 - core.y0, scene_, data_.space, options_, image);
      else
        resolve(film, band.y0 - core.y0, image, options_.threads);
      if (!pilots()) observers_.rowsChanged(image, band.y0 - core.y0, band.y1 - core.y0);
    });
  }

  void showBand(const Crop& band, const Crop& core, Image& image) {
    resolveBand(band, core, image);
    ++stats_.bands;
  }

  /// A band has n of its samples.
  void passDone(const Crop& band, std::uint32_t n, std::uint32_t of) {
    if (pilots()) return;
    const double share = static_cast<double>(n) / of;
    observers_.progress((band.y0 - core_.y0 + share * (band.y1 - band.y0)) / (core_.y1 - core_.y0),
                        stats_.samples);
    if (n < of && observers_.due()) resolveBand(band, core_, image_);
  }

  Image samplesLayer(const Image& picture, const Reached& reached) const {
    if (map_) return stats_.adaptive.samples;
    Image image = blackImage(picture.width, picture.height, {"samples"});
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        image.at(x, y, 0) = static_cast<float>(reached.samplesIn(y, scene_.sampler.sampleCount));
    return image;
  }

  Passes& passes_;
  const SceneData& data_;
  const RenderPlan& plan_;
  const Scene& scene_;
  const RenderOptions& options_;
  const Crop core_;
  Observers& observers_;
  FilmState& state_;
  Stats& stats_;
  const Rendering* picture_ = nullptr;
  Image image_;
  std::optional<SampleMap> map_;  ///< of adaptive sampling, once it is decided
};

}  // namespace

Rendered renderPictures(Passes& passes, const Film& film, std::vector<Rendering> pictures,
                        FilmState& state, Stats& stats) {
  return Render(passes, film, state, stats).run(std::move(pictures));
}

}  // namespace laver
