#include "lab/explain/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/parallel.h"
#include "lab/explain/samples.h"

namespace laver {
namespace {

using Decisions = Explanation::Decisions;

/// One sample a pixel that stays in its pixel.
Scene oneSample(Scene scene, const IntegratorRow& integrator) {
  scene.integrator = {&integrator};
  scene.sampler.sampleCount = 1;
  scene.filter = filterOf(filters::box);
  return scene;
}

void add(ExplainedChannel& channel, double ulps, bool within, int x, int y) {
  if (channel.ulps.empty() || ulps > channel.worst) {
    channel.worst = ulps;
    channel.x = x;
    channel.y = y;
  }
  channel.ulps.push_back(ulps);
  channel.unexplained += within ? 0 : 1;
}

/// Counts of up to 1, 4, 16 ... ulp.
std::string histogram(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  std::string text;
  auto from = values.begin();
  for (double edge = 1.0; from != values.end(); edge *= 4.0) {
    const auto to = std::upper_bound(from, values.end(), edge);
    text += fmt::format("  <={:g}: {}", edge, to - from);
    from = to;
  }
  return text;
}

/// Both sides of a comparison.
class Comparison {
 public:
  Comparison(const Scene& scene, const Scene& judged, const VulkanOptions& vulkan)
      : depthTruth_(oneSample(judged, integrators::depth)),
        normalTruth_(oneSample(judged, integrators::normals)),
        litTruth_(oneSample(judged, integrators::directWhitted)),
        lit_(scene.integrator.is(integrators::directWhitted)),
        depthReference_(depthTruth_),
        normalReference_(normalTruth_),
        litReference_(litTruth_),
        bounds_(depthTruth_) {
    Renderer renderer(vulkan);
    const auto render = [&](const Scene& s) {
      Stats stats;
      return renderer.render(s, {}, stats).image;
    };
    ids_ = render(numbered(oneSample(scene, integrators::normals)));
    depth_ = render(oneSample(scene, integrators::depth));
    normal_ = render(oneSample(scene, integrators::normals));
    if (lit_) radiance_ = render(oneSample(scene, integrators::directWhitted));
  }

  Explanation run() {
    result_.channels = {{.name = "depth"}, {.name = "normal"}};
    if (lit_) result_.channels.push_back({.name = "radiance"});
    for (ExplainedChannel& c : result_.channels) c.worst = -1.0;
    const auto rows = static_cast<std::size_t>(depth_.height);
    parallelFor(rows, 4, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t y = begin; y < end; ++y)
        for (int x = 0; x < depth_.width; ++x) sample(x, static_cast<int>(y));
    });
    for (ExplainedChannel& c : result_.channels) c.worst = std::max(c.worst, 0.0);
    return std::move(result_);
  }

 private:
  /// Film positions are floats: some lie on the border of two pixels, and the box filter gives
  /// them to both. A pixel that shows more than its own sample is left out.
  bool showsOneSample(int x, int y) const {
    int count = 0;
    for (int py = std::max(y - 1, 0); py <= std::min(y + 1, depth_.height - 1); ++py)
      for (int px = std::max(x - 1, 0); px <= std::min(x + 1, depth_.width - 1); ++px) {
        const glm::vec2 at = depthReference_.samplePosition(px, py, 0);
        count += std::abs(at.x - static_cast<float>(x) - 0.5F) <= 0.5F &&
                         std::abs(at.y - static_cast<float>(y) - 0.5F) <= 0.5F
                     ? 1
                     : 0;
      }
    return count == 1;
  }

  void sample(int x, int y) {
    if (!showsOneSample(x, y)) return;
    const dvec2 film(depthReference_.samplePosition(x, y, 0));
    const auto truth = depthReference_.closest(film);
    const auto id = numberOf(depthTruth_, pixelOf(ids_, x, y));
    const std::optional<std::uint32_t> wanted =
        truth ? std::optional(truth->triangle) : std::nullopt;
    const auto seen = static_cast<double>(depth_.at(x, y, 0));
    if (id != wanted) {
      const bool explained = otherHitExplained(film, id, seen);
      const std::lock_guard lock(mutex_);
      ++result_.samples;
      ++result_.idMismatches;
      result_.idExplained += explained ? 1 : 0;
      if (!explained)
        note(x, y, fmt::format("triangle {} instead of {}", nameOf(id), nameOf(wanted)));
      return;
    }
    if (!truth) {
      background(film, x, y);
      return;
    }
    const Bounds bounds = bounds_.at(truth->triangle, truth->u, truth->v);
    const double depth = depthReference_.radiance(film).x;
    const dvec3 normal = normalReference_.radiance(film);
    const double normalOff = largest(pixelOf(normal_, x, y) - normal);
    const double depthOff = std::abs(seen - depth);
    double litOff = 0, litUlps = 0;
    bool shadow = false, shadowExplained = false;
    if (lit_) {
      const dvec3 wantedLight = litReference_.radiance(film), got = pixelOf(radiance_, x, y);
      litOff = largest(got - wantedLight);
      litUlps = litOff / ulpOf(largest(wantedLight));
      // A light that only one of the two sees; small ones hide in the bound.
      shadow = !(litOff <= bounds.radiance);
      shadowExplained = shadow && !litReference_.decided(film, 4.0 * bounds.pixels, 0.5 * litOff);
    }
    const std::lock_guard lock(mutex_);
    ++result_.samples;
    put(0, x, y, depthOff / ulpOf(depth), depthOff <= bounds.depth * depth, bounds.cause);
    put(1, x, y, normalOff / 0x1p-24, normalOff <= bounds.normal, bounds.cause);
    if (!lit_) return;
    if (shadow) {
      ++result_.shadowMismatches;
      result_.shadowExplained += shadowExplained ? 1 : 0;
      if (!shadowExplained) note(x, y, fmt::format("radiance off by {:.3g}", litOff));
    } else {
      put(2, x, y, litUlps, true, bounds.cause);
    }
  }

  /// Where both meet nothing: within rounding, or a ray within the bound sees as much more or less.
  void background(dvec2 film, int x, int y) {
    double off = 0, size = 0;
    if (lit_) {
      const dvec3 wanted = litReference_.radiance(film);
      off = largest(pixelOf(radiance_, x, y) - wanted);
      size = largest(wanted);
    }
    const bool within = off <= 16.0 * 0x1p-24 * size ||
                        !litReference_.decided(film, bounds_.pixelsOfBackground(), 0.5 * off);
    const std::lock_guard lock(mutex_);
    ++result_.samples;
    if (lit_ && litTruth_.environment) put(2, x, y, off / ulpOf(size), within, "background");
  }

  /// Does a ray within the bound meet that triangle, or is the hit as far away as the reference's,
  /// on a coincident surface?
  bool otherHitExplained(dvec2 film, std::optional<std::uint32_t> id, double depth) const {
    const auto truth = depthReference_.closest(film);
    double distance = truth ? bounds_.distanceOf(truth->triangle, truth->u, truth->v)
                            : std::numeric_limits<double>::infinity();
    if (id) distance = std::min(distance, 1.0 / depth);
    const double delta = bounds_.pixelsAt(distance);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const auto near = depthReference_.closest(film + delta * dvec2(dx, dy));
        if (!near ? !id : id == near->triangle) return true;
      }
    if (!truth || !id) return false;
    const Bounds bounds = bounds_.at(truth->triangle, truth->u, truth->v);
    const double wanted = depthReference_.radiance(film).x;
    return std::abs(depth - wanted) <= bounds.depth * wanted;
  }

  // With the lock held.
  void put(std::size_t channel, int x, int y, double ulps, bool within, const std::string& cause) {
    ExplainedChannel& c = result_.channels[channel];
    c.ulps.push_back(ulps);
    if (!within) {
      ++c.mismatches;
      note(x, y, fmt::format("{} off by {:.3g} ulp", c.name, ulps));
    }
    if (ulps < c.worst || (ulps == c.worst && std::pair(y, x) > std::pair(c.y, c.x))) return;
    c.worst = ulps;
    c.x = x;
    c.y = y;
    c.cause = cause;
  }
  void note(int x, int y, const std::string& what) {
    if (!result_.first.empty() && std::pair(firstY_, firstX_) < std::pair(y, x)) return;
    firstX_ = x;
    firstY_ = y;
    result_.first = fmt::format("pixel {}, {}: {}", x, y, what);
  }
  static std::string nameOf(std::optional<std::uint32_t> id) {
    return id ? std::to_string(*id) : "none";
  }

  Scene depthTruth_, normalTruth_, litTruth_;
  bool lit_;
  Reference depthReference_, normalReference_, litReference_;
  BoundsOf bounds_;
  Image ids_, depth_, normal_, radiance_;
  std::mutex mutex_;
  Explanation result_;
  int firstX_ = 0, firstY_ = 0;
};

}  // namespace

std::uint64_t Explanation::unexplained() const {
  std::uint64_t sum = hits.unexplained() + occlusion.unexplained();
  for (const ExplainedChannel& c : channels) sum += c.unexplained;
  return sum;
}

Explanation explain(const Scene& scene, const Scene& judged, const VulkanOptions& vulkan) {
  const SampleComparison comparison(scene, judged, vulkan);
  const auto width = static_cast<std::size_t>(comparison.width());
  std::vector<ComparedSample> samples(width * static_cast<std::size_t>(comparison.height()));
  parallelFor(samples.size(), 256, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      samples[i] = comparison.at(static_cast<int>(i % width), static_cast<int>(i / width));
  });

  Explanation result;
  for (std::size_t q = 0; q < (comparison.hasValue() ? kQuantities : kValue); ++q)
    result.channels.push_back({.name = kQuantityNames[q]});
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const ComparedSample& sample = samples[i];
    const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
    if (sample.leftOut) continue;
    ++result.samples;
    count(result.hits, sample.otherHit, sample.explained);
    count(result.occlusion, sample.otherOcclusion, sample.explained);
    for (std::size_t q = 0; q < result.channels.size(); ++q)
      if (sample.ulps[q] >= 0.0) add(result.channels[q], sample.ulps[q], sample.within[q], x, y);
    if (result.first.empty() && !sample.unexplained.empty())
      result.first = fmt::format("pixel {}, {}: {}", x, y, sample.unexplained);
  }
  for (ExplainedChannel& c : result.channels)
    if (!c.ulps.empty()) c.cause = comparison.causeAt(c.x, c.y);
  return result;
}

std::string describe(const Explanation& e) {
  std::string text = fmt::format("{} samples\n", e.samples);
  text += fmt::format("other hit: {}, {} of them explained\n", e.hits.differing, e.hits.explained);
  text += fmt::format("other occlusion: {}, {} of them explained\n", e.occlusion.differing,
                      e.occlusion.explained);
  for (const ExplainedChannel& c : e.channels)
    text += fmt::format("{} [ulp]:{}\n  beyond the bound: {}; worst {:.3g} at pixel {}, {}: {}\n",
                        c.name, histogram(c.ulps), c.unexplained, c.worst, c.x, c.y, c.cause);
  return text + fmt::format("unexplained: {}{}\n", e.unexplained(),
                            e.unexplained() == 0 ? "" : "; " + e.first);
}

}  // namespace laver
