#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/bench.h"
#include "bench/embree_pass.h"
#include "bench/laver_pass.h"
#include "bench/scenes.h"
#include "render/traversal.h"

namespace laver::bench {
namespace {

/// How much sooner laver is where it leaves out what sees nothing.
const char* const kAsRendered = "as rendered";

struct Side {
  std::string name;
  EmbreeCall call;
  std::vector<double> seconds;
  std::vector<float> image;
  double outside = 0;
};

struct Setup {
  std::string name;
  const IntegratorRow* integrator;
  std::uint32_t samples;
  unsigned threads;
  bool everyCall;  ///< all of Embree's forms, else those that the figures name
};

std::vector<Side> sidesOf(const EmbreeScenes& e, const Setup& setup) {
  std::vector<Side> sides;
  const auto add = [&](const char* name, const EmbreeScene& scene, int width, bool together) {
    sides.push_back({name, {scene.get(), width, together}, {}, {}, 0});
  };
  add("ray16 robust", e.robust, 16, false);
  if (setup.samples == 16) add("ray16 robust, samples together", e.robust, 16, true);
  add("ray16 robust avx2", e.robustAvx2, 16, false);
  add("ray8 robust avx2", e.robustAvx2, 8, false);
  if (!setup.everyCall) return sides;
  add("generate and store alone", e.robust, 0, false);
  add("ray16", e.plain, 16, false);
  add("ray16 avx2", e.plainAvx2, 16, false);
  add("ray16 robust, quality high", e.robustHigh, 16, false);
  add("ray8 robust", e.robust, 8, false);
  add("ray8", e.plain, 8, false);
  add("ray8 avx2", e.plainAvx2, 8, false);
  add("ray1 robust", e.robust, 1, false);
  add("ray1", e.plain, 1, false);
  add("ray1 robust avx2", e.robustAvx2, 1, false);
  add("ray1 avx2", e.plainAvx2, 1, false);
  return sides;
}

/// Share of pixels that differ by more than 1e-3, relatively or where small absolutely: rays at
/// edges, silhouettes and shadow borders.
double differing(const Image& laver, const std::vector<float>& sums, std::size_t samples) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < sums.size(); i += 3) {
    bool differs = false;
    for (std::size_t c = i; c < i + 3; ++c) {
      const float mean = sums[c] / static_cast<float>(samples);
      differs = differs || !(std::abs(mean - laver.pixels[c]) <= 1e-3F * std::max(mean, 1e-2F));
    }
    count += differs ? 1 : 0;
  }
  return static_cast<double>(count) * 3.0 / static_cast<double>(sums.size());
}

/// Returns how many times laver's speed is that of each side, every ray traced by both.
std::map<std::string, double> comparePasses(Report& report, const EmbreeScenes& embree, Scene scene,
                                            const Setup& setup, const Rounds& rounds) {
  scene.integrator = {setup.integrator};
  scene.sampler.sampleCount = setup.samples;
  const auto pixels = static_cast<std::uint64_t>(scene.camera.width) *
                      static_cast<std::uint64_t>(scene.camera.height);
  EmbreePass pass(packScene(scene, {}, specialise(scene, {})), setup.samples);
  std::vector<Side> sides = sidesOf(embree, setup);
  EmbreePass::Result result;
  // A scene without lights is black: its samples are made and stored, and no ray is traced.
  Scene unlit = scene;
  unlit.integrator = {&integrators::directWhitted};
  unlit.lights.clear();
  std::vector<double> seconds, rendered, alone;
  LaverRender laver, asRendered;
  // A whole render each round; the first, which may compile the kernel, is not counted.
  const std::size_t count = setup.samples == 1 ? rounds.passes : rounds.renders;
  for (std::size_t round = 0; round <= count; ++round) {
    laver = renderWithLaver(scene, setup.threads, fasterPackets(scene), true);
    asRendered = renderWithLaver(scene, setup.threads, fasterPackets(scene));
    if (round > 0) seconds.push_back(laver.stats.seconds.trace);
    if (round > 0) rendered.push_back(asRendered.stats.seconds.trace);
    if (setup.everyCall || setup.samples == 16) {
      const auto made = renderWithLaver(unlit, setup.threads, fasterPackets(scene), true).stats;
      if (round > 0) alone.push_back(made.seconds.trace);
    }
    for (Side& side : sides) {
      result = pass.run(side.call, 0, setup.samples, setup.threads);
      if (round > 0) side.seconds.push_back(result.seconds);
      if (round == 0) pass.addTo(side.image, side.call, setup.samples);
    }
  }
  for (Side& side : sides) {
    std::vector<double> outside(setup.samples == 1 ? 3 : 1);
    for (double& share : outside)
      share = pass.run(side.call, 0, setup.samples, setup.threads, true).outside;
    side.outside = median(outside);
  }

  const bool shadows = setup.integrator == &integrators::directWhitted;
  const auto rays = static_cast<double>(pixels * setup.samples + result.shadowRays);
  report.section(
      fmt::format("Whole pass: {}, {} sample{}, {}, {} thread{}", setup.name, setup.samples,
                  setup.samples == 1 ? "" : "s",
                  shadows ? "primary + shadow (direct_whitted)" : "primary (depth)", setup.threads,
                  setup.threads == 1 ? "" : "s"),
      {{"triangles", laver.stats.triangles},
       {"hits", static_cast<double>(result.hits) / static_cast<double>(pixels * setup.samples)},
       {"rays", rays}});
  const double laverMedian = median(seconds);
  report.timing("laver " + laver.stats.traversal, seconds, rays, 0,
                {{"samples a pass", laver.stats.samplesAPass}});
  report.timing("laver, what sees something", rendered, rays, laverMedian,
                {{"of the film", asRendered.stats.seen}});
  if (!alone.empty()) report.timing("laver, generate and store alone", alone, rays, laverMedian);
  std::map<std::string, double> ratios;
  ratios[kAsRendered] = laverMedian / median(rendered);
  for (const Side& side : sides) {
    ratios[side.name] = median(side.seconds) / laverMedian;
    report.timing(side.name, side.seconds, rays, laverMedian,
                  {{"outside rtc", side.outside},
                   {"differing", differing(laver.image, side.image, scene.sampler.sampleCount)}});
  }
  return ratios;
}

}  // namespace

void benchPasses(Report& report, const EmbreeDevices& devices, const Rounds& rounds) {
  const IntegratorRow *const depth = &integrators::depth, *const whitted =
                                                              &integrators::directWhitted;
  struct View {
    std::string scene;
    int subdivided;
    std::vector<Setup> setups;
  };
  const std::vector<View> views = {
      {"torus", 0, {{"torus", depth, 1, 2, false}, {"torus", whitted, 1, 2, false}}},
      {"bunny",
       0,
       {{"bunny", depth, 1, 2, true},
        {"bunny", whitted, 1, 2, true},
        {"bunny", depth, 1, 1, false},
        {"bunny", whitted, 1, 1, false},
        {"bunny", depth, 16, 2, false},
        {"bunny", whitted, 16, 2, false}}},
      {"bunny-close",
       0,
       {{"bunny-close", depth, 1, 2, false},
        {"bunny-close", whitted, 1, 2, false},
        {"bunny-close", whitted, 16, 2, false}}},
      {"bunny",
       2,
       {{"bunny x16", depth, 1, 2, false},
        {"bunny x16", whitted, 1, 2, false},
        {"bunny x16", whitted, 16, 2, false}}},
      {"bunny-close", 2, {{"bunny-close x16", whitted, 1, 2, false}}},
  };
  std::map<std::string, std::map<std::string, double>> ratios;
  for (const View& view : views) {
    const Scene scene = benchScene(view.scene, view.subdivided);
    const EmbreeScenes embree(devices, scene);
    for (const Setup& setup : view.setups)
      ratios[fmt::format("{} {} {} {}", setup.name, setup.samples,
                         setup.integrator == depth ? "primary" : "shadow", setup.threads)] =
          comparePasses(report, embree, scene, setup, rounds);
  }
  // Embree's packets hold 4 x 4 pixels; at 16 samples they can hold those of one pixel instead.
  const std::string pixels = "ray16 robust", together = "ray16 robust, samples together";
  const auto figure = [&](const std::string& name, const char* key, const char* wanted) {
    const auto& sides = ratios.at(key);
    report.figure(name + ", whole pass", sides.at(pixels), wanted);
    report.figure("the same picture, what sees nothing left out",
                  sides.at(pixels) * sides.at(kAsRendered), "");
    if (sides.contains(together))
      report.figure("the same against samples together", sides.at(together), "");
  };
  figure("bunny, 1 sample, primary", "bunny 1 primary 2", "1.8");
  figure("bunny, 1 sample, primary + shadow", "bunny 1 shadow 2", "1.5");
  figure("bunny, 16 samples, primary", "bunny 16 primary 2", "2.2");
  figure("bunny, 16 samples, primary + shadow", "bunny 16 shadow 2", "1.8");
  figure("1.1 M triangles, 1 sample, primary + shadow", "bunny x16 1 shadow 2", "0.8");
  figure("1.1 M triangles, 16 samples, primary + shadow", "bunny x16 16 shadow 2", "1.4");
}

}  // namespace laver::bench
