#include "reference/film.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "reference/sampler.h"
#include "render/strips.h"

namespace laver::reference {

namespace {

constexpr std::size_t samplesAtOnce = 1u << 18;

struct Sample {
  glm::vec2 film;
  glm::dvec3 value;
  bool kept;
};

struct Sums {
  glm::dvec3 value{0.0};
  double weight = 0.0;
};

std::size_t index(int value) { return static_cast<std::size_t>(value); }

Crop checkedCore(const Camera& camera, const RenderOptions& options) {
  const Crop crop = coreOf(camera, options);
  if (crop.x0 < 0 || crop.y0 < 0 || crop.x1 > camera.width || crop.y1 > camera.height ||
      crop.x0 >= crop.x1 || crop.y0 >= crop.y1) {
    throw Error(ExitCode::Usage,
                "the crop " + std::to_string(crop.x0) + "," + std::to_string(crop.y0) + "," +
                    std::to_string(crop.x1) + "," + std::to_string(crop.y1) +
                    " is empty or not inside the film of " + std::to_string(camera.width) + "x" +
                    std::to_string(camera.height) + " pixels");
  }
  return crop;
}

bool usable(const glm::dvec3& v, bool isSigned) {
  const auto good = [&](double x) { return std::isfinite(x) && (isSigned || x >= 0.0); };
  return good(v.x) && good(v.y) && good(v.z);
}

// One band of the crop: its pixels, and the samples of these and of the pixels around them.
class Band {
 public:
  Band(const Scene& scene, const RenderOptions& options, const Crop& pixels, bool isSigned)
      : scene_(scene),
        isSigned_(isSigned),
        threads_(options.threads),
        weights_(scene.filter, options.noriCompat),
        pixels_(pixels),
        around_{std::max(pixels.x0 - weights_.reach(), 0),
                std::max(pixels.y0 - weights_.reach(), 0),
                std::min(pixels.x1 + weights_.reach(), scene.camera.width),
                std::min(pixels.y1 + weights_.reach(), scene.camera.height)},
        sums_(index(pixels.x1 - pixels.x0) * index(pixels.y1 - pixels.y0)) {}

  // Number of pixels whose samples are traced.
  std::size_t traced() const { return width() * index(around_.y1 - around_.y0); }

  // Traces samples [begin, end) per pixel; returns how many samples of the band's own pixels are
  // dropped.
  std::uint64_t trace(std::uint32_t begin, std::uint32_t end, const RadianceAt& radianceAt) {
    samples_.resize(traced() * (end - begin));
    std::atomic<std::uint64_t> dropped{0};
    parallelFor(samples_.size(), 256, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const int x = around_.x0 + static_cast<int>(i % traced() % width());
        const int y = around_.y0 + static_cast<int>(i % traced() / width());
        const auto sample = begin + static_cast<std::uint32_t>(i / traced());
        const glm::vec2 film = samplePosition(scene_.camera, scene_.sampler, x, y, sample);
        const Numbers numbers(scene_.camera, scene_.sampler, {x, y, sample});
        const glm::dvec3 value = radianceAt(glm::dvec2(film), numbers);
        samples_[i] = {film, value, usable(value, isSigned_)};
        const bool own = x >= pixels_.x0 && x < pixels_.x1 && y >= pixels_.y0 && y < pixels_.y1;
        if (own && !samples_[i].kept) ++dropped;
      }
    });
    return dropped;
  }

  // Adds the traced samples to the pixels.
  void gather() {
    const std::size_t columns = index(pixels_.x1 - pixels_.x0);
    parallelFor(sums_.size(), 256, threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        gather(pixels_.x0 + static_cast<int>(i % columns),
               pixels_.y0 + static_cast<int>(i / columns), sums_[i]);
      }
    });
  }

  void addTo(PixelVariances& variances) const {
    const auto n = static_cast<std::uint32_t>(samples_.size() / traced());
    variances.add(pixels_, around_, n, [&](int x, int y, std::uint32_t number) {
      const Sample& sample =
          samples_[number * traced() + index(y - around_.y0) * width() + index(x - around_.x0)];
      return PixelVariances::Sample{glm::dvec2(sample.film) - glm::dvec2(x, y), sample.value,
                                    sample.kept};
    });
  }

  // Writes the pixels to rows of a picture, from `row` on.
  void write(int row, Image& image) const {
    auto sums = sums_.begin();
    for (int y = row; y < row + pixels_.y1 - pixels_.y0; ++y) {
      for (int x = 0; x < image.width; ++x, ++sums) {
        for (int c = 0; c < 3; ++c) {
          image.at(x, y, index(c)) =
              sums->weight == 0.0 ? 0.0f : static_cast<float>(sums->value[c] / sums->weight);
        }
      }
    }
  }

 private:
  std::size_t width() const { return index(around_.x1 - around_.x0); }

  void gather(int x, int y, Sums& sums) const {
    const int reach = weights_.reach();
    for (std::size_t pass = 0; pass < samples_.size(); pass += traced()) {
      for (int v = std::max(y - reach, around_.y0); v <= y + reach && v < around_.y1; ++v) {
        for (int u = std::max(x - reach, around_.x0); u <= x + reach && u < around_.x1; ++u) {
          const Sample& sample =
              samples_[pass + index(v - around_.y0) * width() + index(u - around_.x0)];
          if (!sample.kept) continue;
          const glm::dvec2 distance = glm::dvec2(sample.film) - (glm::dvec2(x, y) + 0.5);
          const double weight = weights_(distance.x) * weights_(distance.y);
          sums.value += weight * sample.value;
          sums.weight += weight;
        }
      }
    }
  }

  const Scene& scene_;
  bool isSigned_;
  unsigned threads_;
  FilterWeights weights_;
  Crop pixels_, around_;
  std::vector<Sample> samples_;
  std::vector<Sums> sums_;
};

}  // namespace

Rendered renderFilm(const Scene& scene, const RenderOptions& options, const Picture& picture,
                    Observers& observers) {
  const Crop crop = checkedCore(scene.camera, options);
  const std::uint32_t count = scene.sampler.sampleCount;
  const auto columns = index(crop.x1 - crop.x0);
  const int rows = static_cast<int>(std::max<std::size_t>(samplesAtOnce / columns, 16));
  observers.beginPicture(picture.index, picture.count);
  const std::vector<Strip> strips = stripsOf(scene, options);
  const int height = rowsOf(strips);
  const std::uint64_t all = std::uint64_t{columns} * index(height) * count;
  Rendered rendered{rgbImage(crop.x1 - crop.x0, height), {}, 0};
  // A variance takes several samples at once, and their number must not depend on the shard.
  const std::size_t least = picture.variances != nullptr ? 16 : 1;
  const int around = 2 * FilterWeights(scene.filter, options.noriCompat).reach();
  const std::size_t traced =
      index(std::min(crop.x1 - crop.x0 + around, scene.camera.width)) *
      index(std::min(std::min(rows, crop.y1 - crop.y0) + around, scene.camera.height));
  const auto batch =
      static_cast<std::uint32_t>(std::max<std::size_t>(samplesAtOnce / traced, least));
  std::uint32_t done = count;
  for (const Strip& at : bandsIn(strips, rows)) {
    if (done != count) break;
    Band band(scene, options, at.pixels, picture.isSigned);
    const auto show = [&] {
      band.write(at.row, rendered.image);
      observers.rowsChanged(rendered.image, at.row, at.row + at.rows());
    };
    for (done = 0; done < count && !observers.stop();) {
      const std::uint32_t end = done + std::min(batch, count - done);
      rendered.droppedSamples += band.trace(done, end, picture.radianceAt);
      band.gather();
      if (picture.variances != nullptr) band.addTo(*picture.variances);
      done = end;
      const double share = (at.row + static_cast<double>(end) / count * at.rows()) / height;
      observers.progress(share, picture.index * all +
                                    static_cast<std::uint64_t>(share * static_cast<double>(all)));
      if (done < count && observers.due()) observers.show(show);
    }
    rendered.reached.addRows(at.rows(), done, count);
    observers.show(show);
  }
  return rendered;
}

}  // namespace laver::reference
