#include "bench/embree_film.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <thread>

#include "bench/embree_chunk.h"
#include "core/error.h"
#include "render/specialise.h"

namespace laver::bench {
namespace {

/// exp(x) for -87 <= x <= 0, by its Taylor polynomial around whole powers of 2; it has no call in
/// it, so that compilers make vectors of it.
float expOf(float x) {
  const float n = std::floor(x * 1.44269504F + 0.5F);
  const float r = (x - n * 0.693359375F) + n * 2.12194440e-4F;
  const float p =
      1.0F + r * (1.0F + r * (0.5F + r * (1.0F / 6.0F +
                                          r * (1.0F / 24.0F + r * (1.0F / 120.0F + r / 720.0F)))));
  return p * std::bit_cast<float>((static_cast<int>(n) + 127) << 23);
}

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

LaneFilter::LaneFilter(const Filter& filter)
    : filter_(filter), apron_(static_cast<int>(apronOf(filter.radius))) {
  if (apron_ > kMostApron)
    throw Error(ExitCode::Scene, "Embree's side has no filters that reach beyond 4 pixels");
}

void LaneFilter::weights(const float (&inside)[16], float (*to)[16]) const {
  const auto radius = static_cast<float>(filter_.radius);
  const auto alpha = static_cast<float>(-0.5 / (filter_.stddev * filter_.stddev));
  const float end = std::exp(alpha * radius * radius);
  const auto B = static_cast<float>(filter_.B), C = static_cast<float>(filter_.C);
  for (int k = 0; k < side(); ++k) {
    const float centre = static_cast<float>(k - apron_) + 0.5F;
    for (int i = 0; i < 16; ++i) {
      const float x = std::abs(inside[i] - centre);
      float w = 1.0F;
      if (filter_.row == &filters::gaussian)
        w = std::max(0.0F, expOf(std::max(alpha * x * x, -87.0F)) - end);
      if (filter_.row == &filters::tent) w = std::max(0.0F, 1.0F - x / radius);
      if (filter_.row == &filters::mitchell) {
        const float s = 2.0F * x / radius, y = 2.0F - s;
        const float inner =
            ((12.0F - 9.0F * B - 6.0F * C) * s + (-18.0F + 12.0F * B + 6.0F * C)) * s * s +
            (6.0F - 2.0F * B);
        const float outer = y * y * ((B + 6.0F * C) * y - 6.0F * C);
        w = s < 1.0F ? inner : outer;
      }
      to[k][i] = x <= radius ? w : 0.0F;
    }
  }
}

EmbreeFilm::EmbreeFilm(const Filter& filter, int width, int height)
    : filter_(filter), width_(width), height_(height), sums_(index(width) * index(height) * 4) {}

void EmbreeFilm::add(int x, int y, int columns, int rows, const std::vector<float>& sums) {
  for (int v = std::max(0, -y); v < std::min(rows, height_ - y); ++v)
    for (int u = std::max(0, -x); u < std::min(columns, width_ - x); ++u)
      for (std::size_t c = 0; c < 4; ++c)
        sums_[(index(y + v) * index(width_) + index(x + u)) * 4 + c] +=
            static_cast<double>(sums[(index(v) * index(columns) + index(u)) * 4 + c]);
}

Image EmbreeFilm::image() const {
  Image image = rgbImage(width_, height_);
  for (std::size_t i = 0; i < image.pixels.size() / 3; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const double weight = sums_[i * 4 + 3];
      image.pixels[i * 3 + c] =
          weight == 0.0 ? 0.0F : static_cast<float>(sums_[i * 4 + c] / weight);
    }
  return image;
}

/// Lanes keep sums of their own for each pixel around, which are added up when the pixels change.
void EmbreePass::addTo(EmbreeFilm& film, const EmbreeCall& call, std::uint32_t count,
                       unsigned threads) const {
  struct Part {
    int x, y, rows;
    std::size_t slot;
    std::vector<float> sums;
  };
  const int width = static_cast<int>(params_.film.x), height = static_cast<int>(params_.film.y);
  const LaneFilter& filter = film.filter();
  const int apron = filter.apron(), side = filter.side(), columns = kBlock + 2 * apron;
  std::vector<Part> parts;
  for (int y = 0; y < height; y += kBlock)
    for (int x = 0; x < width; x += kBlock) {
      const int rows = std::min(kBlock, height - y);
      parts.push_back(
          {x, y, rows, static_cast<std::size_t>(y * width + x * rows) / 16 * count, {}});
    }
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    alignas(64) float lanes[LaneFilter::kMostSide * LaneFilter::kMostSide][4][16];
    alignas(64) float byColumn[LaneFilter::kMostSide][16], byRow[LaneFilter::kMostSide][16];
    for (std::size_t p = next++; p < parts.size(); p = next++) {
      Part& part = parts[p];
      part.sums.assign(index(columns) * index(part.rows + 2 * apron) * 4, 0.0F);
      const int step = call.together ? 1 : 16;
      const std::size_t together = call.together ? count / 16 : count;
      for (int pixel = 0; pixel < part.rows * kBlock; pixel += step) {
        std::fill_n(&lanes[0][0][0], side * side * 64, 0.0F);
        for (std::size_t s = 0; s < together; ++s) {
          const Stored& in = stored_[part.slot++];
          filter.weights(in.x, byColumn);
          filter.weights(in.y, byRow);
          for (int v = 0; v < side; ++v)
            for (int u = 0; u < side; ++u) {
              float(&sum)[4][16] = lanes[v * side + u];
              for (int i = 0; i < 16; ++i) {
                const float w = byColumn[u][i] * byRow[v][i];
                sum[0][i] += w * in.red[i];
                sum[1][i] += w * in.green[i];
                sum[2][i] += w * in.blue[i];
                sum[3][i] += w;
              }
            }
        }
        const glm::ivec2 at = placeInBlock(pixel);
        for (int v = 0; v < side; ++v)
          for (int u = 0; u < side; ++u)
            for (int c = 0; c < 4; ++c)
              for (int i = 0; i < 16; ++i) {
                const int x = at.x + u + (call.together ? 0 : i % 4);
                const int y = at.y + v + (call.together ? 0 : i / 4);
                part.sums[(index(y) * index(columns) + index(x)) * 4 + index(c)] +=
                    lanes[v * side + u][c][i];
              }
      }
    }
  };
  std::vector<std::thread> others;
  for (unsigned t = 1; t < threads; ++t) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  for (const Part& part : parts)
    film.add(part.x - apron, part.y - apron, columns, part.rows + 2 * apron, part.sums);
}

}  // namespace laver::bench
