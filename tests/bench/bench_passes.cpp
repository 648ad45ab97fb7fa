#include <fmt/format.h>

#include "bench/bench.h"
#include "bench/laver_pass.h"
#include "bench/scenes.h"
#include "render/traversal.h"

namespace laver::bench {
namespace {

struct Setup {
  const char* scene;
  int subdivided;
  const char* integrator;
  std::uint32_t samples;
  unsigned threads;
};

constexpr Setup kSetups[] = {
    {"torus", 0, "depth", 1, 2},
    {"torus", 0, "direct_whitted", 1, 2},
    {"bunny", 0, "depth", 1, 2},
    {"bunny", 0, "direct_whitted", 1, 2},
    {"bunny", 0, "direct_whitted", 1, 1},
    {"bunny", 0, "depth", 16, 2},
    {"bunny", 0, "direct_whitted", 16, 2},
    {"bunny-close", 0, "direct_whitted", 1, 2},
    {"bunny-close", 0, "direct_whitted", 16, 2},
    {"bunny", 2, "direct_whitted", 1, 2},
    {"bunny", 2, "direct_whitted", 16, 2},
};

/// Measures whole renders. The first, which may compile kernels, is not counted.
void measure(Report& report, const Setup& setup, std::size_t rounds) {
  const Scene scene = benchScene(setup.scene, setup.subdivided, setup.integrator, setup.samples);
  const double rays = 1.0 * scene.camera.width * scene.camera.height * setup.samples;
  std::vector<double> trace, skipping, reconstruct, compile;
  Stats stats;
  for (std::size_t round = 0; round <= rounds; ++round) {
    const auto every =
        renderWithLaver(scene, setup.threads, traversalName(fasterPackets(scene)), true);
    stats = renderWithLaver(scene, setup.threads, traversalName(fasterPackets(scene)));
    if (round == 0) continue;
    trace.push_back(every.seconds.trace);
    skipping.push_back(stats.seconds.trace);
    reconstruct.push_back(stats.seconds.reconstruct);
    compile.push_back(stats.seconds.compile);
  }
  report.section(fmt::format("Render: {}, {}, {}, {}", titleOf(setup.scene, setup.subdivided),
                             setup.integrator, counted(setup.samples, "sample"),
                             counted(setup.threads, "thread")),
                 {{"triangles", stats.triangles},
                  {"camera rays", rays},
                  {"share of the film that can see geometry", stats.coverage}});
  report.timing("trace, all pixels, " + stats.traversal, trace, rays);
  report.timing("trace, pixels that can see geometry", skipping, rays, median(trace));
  report.timing("reconstruct", reconstruct);
  report.timing("compile, cached", compile);
}

}  // namespace

void benchPasses(Report& report, const Rounds& rounds) {
  for (const Setup& setup : kSetups) {
    if (rounds.brief && (setup.subdivided > 0 || setup.samples > 1)) continue;
    measure(report, setup, setup.samples == 1 ? rounds.passes : rounds.renders);
  }
}

}  // namespace laver::bench
