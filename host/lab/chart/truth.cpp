#include "lab/chart/truth.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstring>

#include "lab/chart/errors.h"
#include "lab/chart/films.h"
#include "reference/pcg32.h"
#include "reference/reference.h"

namespace laver::chart {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds kSaveEvery{20};

/// Sample `number` of side * side strata of a pixel, at random in its own. A generator for each
/// pixel and sample, whose sequence is the half's.
glm::dvec2 stratified(int x, int y, int width, std::uint32_t number, std::uint32_t side,
                      std::uint64_t half) {
  const auto pixel = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(width) +
                     static_cast<std::uint64_t>(x);
  reference::Pcg32 random(pixel << 32 | number, half);
  const auto u = static_cast<double>(random.nextFloat());
  const auto v = static_cast<double>(random.nextFloat());
  const std::uint32_t row = number / side;
  return {x + (number % side + u) / side, y + (row + v) / side};
}

/// One half, kept now and then.
class Half {
 public:
  Half(const Kept& kept, std::string key, std::size_t numbers) : kept_(kept), key_(std::move(key)) {
    const auto found = kept.read(key_);
    if (!found || !found->contains("done") || !found->contains("sums")) return;
    const auto& bytes = (*found)["sums"].get_binary();
    if (bytes.size() != numbers * sizeof(double)) return;
    done = (*found)["done"];
    sums.resize(numbers);
    std::memcpy(sums.data(), bytes.data(), bytes.size());
  }

  void save(std::uint32_t count, const std::vector<double>& values) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    kept_.write(key_, {{"done", count},
                       {"sums", nlohmann::json::binary(std::vector<std::uint8_t>(
                                    bytes, bytes + values.size() * sizeof(double)))}});
    saved_ = Clock::now();
  }
  bool due() const { return Clock::now() - saved_ > kSaveEvery; }

  std::uint32_t done = 0;
  std::vector<double> sums;

 private:
  const Kept& kept_;
  std::string key_;
  Clock::time_point saved_ = Clock::now();
};

}  // namespace

std::uint32_t squareFrom(std::uint32_t samples) {
  const auto side = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(samples))));
  return side * side;
}

std::vector<Truth> truthOf(const Scene& scene, std::span<const Filter> filters,
                           const TruthOptions& options, const Kept& kept, const std::string& key) {
  const std::uint32_t count = squareFrom(options.samples);
  const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(count)));
  const Camera& camera = scene.camera;
  std::unique_ptr<Reference> reference;  // its tree is built only where there is work
  std::vector<Films> halves;
  for (std::uint64_t h = 0; h < 2; ++h) {
    Films& films = halves.emplace_back(camera.width, camera.height, filters, options.threads);
    Half half(kept, fmt::format("{} truth half {} of {}", key, h, count), films.sums().size());
    if (half.done > 0) films.sums() = half.sums;
    for (std::uint32_t s = half.done; s < count; ++s) {
      if (options.stop && options.stop()) {
        if (s > half.done) half.save(s, films.sums());
        return {};
      }
      if (!reference) reference = std::make_unique<Reference>(scene, options.threads);
      films.add([&](int x, int y) { return stratified(x, y, camera.width, s, side, h); },
                [&](glm::dvec2 film) { return reference->radiance(film); });
      if (half.due() || s + 1 == count) half.save(s + 1, films.sums());
      if (options.progress) options.progress((static_cast<double>(h) + (s + 1.0) / count) / 2.0);
    }
  }
  std::vector<Truth> truths;
  for (std::size_t f = 0; f < filters.size(); ++f) {
    const Image a = halves[0].picture(f), b = halves[1].picture(f);
    const Errors between = errorsOf(a, b);
    Image mean = a;
    for (std::size_t i = 0; i < mean.pixels.size(); ++i)
      mean.pixels[i] = 0.5F * (a.pixels[i] + b.pixels[i]);
    truths.push_back({std::move(mean), between.rmse / 2.0, between.relativeMse / 4.0});
  }
  return truths;
}

}  // namespace laver::chart
