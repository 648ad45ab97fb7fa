#include <algorithm>
#include <chrono>
#include <cmath>

#include "bench/bench.h"
#include "bench/embree_builds.h"
#include "bench/scenes.h"
#include "core/error.h"
#include "render/packed.h"

namespace laver::bench {
namespace {

double commitSeconds(const EmbreeDevice& device, const EmbreeMesh& mesh, RTCBuildQuality quality) {
  return EmbreeScene(device, mesh, RTC_SCENE_FLAG_NONE, quality).commitSeconds();
}

/// Number of triangles in leaves; split triangles count several times.
std::uint64_t trianglesOf(std::span<const CostItem> items) {
  std::uint64_t sum = 0;
  for (const CostItem& item : items) sum += item.triangles;
  return sum;
}

}  // namespace

void benchBuilds(Report& report, const EmbreeDevices& devices, const Rounds& rounds) {
  for (const int subdivided : {0, 2}) {
    if (rounds.brief && subdivided > 0) continue;
    const std::string title = titleOf("bunny", subdivided);
    const Scene scene = benchScene("bunny", subdivided, "direct_whitted", 1);
    const EmbreeMesh mesh(scene);
    auto triangles = pack(scene, {}, uploadsOf(scene, {})).bvh.triangles;
    std::sort(triangles.begin(), triangles.end(),
              [](const auto& a, const auto& b) { return a.id < b.id; });
    Bvh bvh;
    std::vector<double> laver, medium, high;
    for (std::size_t round = 0; round <= rounds.builds; ++round) {
      const auto start = std::chrono::steady_clock::now();
      bvh = buildBvh(triangles, 2);
      const auto end = std::chrono::steady_clock::now();
      const double m = commitSeconds(devices.native, mesh, RTC_BUILD_QUALITY_MEDIUM);
      const double h = commitSeconds(devices.native, mesh, RTC_BUILD_QUALITY_HIGH);
      if (round == 0) continue;
      laver.push_back(std::chrono::duration<double>(end - start).count());
      medium.push_back(m);
      high.push_back(h);
    }
    const double ours = sahCost(costItems(bvh));
    // The builder's own cost is for boxes before they are grown by an ulp.
    if (std::abs(ours - bvh.sahCost) > 1e-3 * ours)
      throw Error(ExitCode::Output, "the builder and the bench disagree on a tree's SAH cost");
    const auto tree = embreeTree(devices.native, mesh, RTC_BUILD_QUALITY_MEDIUM);
    const auto highTree = embreeTree(devices.native, mesh, RTC_BUILD_QUALITY_HIGH);
    const double theirs = sahCost(tree), best = sahCost(highTree);
    report.section("Tree: " + title + ", 2 threads",
                   {{"triangles", triangles.size()},
                    {"SAH cost laver", ours},
                    {"SAH cost rtcBuildBVH medium", theirs},
                    {"SAH cost rtcBuildBVH high", best},
                    {"triangles in its leaves", trianglesOf(highTree)}});
    report.timing("laver, flattened", laver);
    report.timing("rtcCommitScene medium", medium, 0, median(laver));
    report.timing("rtcCommitScene high", high, 0, median(laver));
    report.figure(title + ": rtcCommitScene medium / laver's build and flattening",
                  median(medium) / median(laver), "");
    report.figure(title + ": SAH cost, laver / rtcBuildBVH medium", ours / theirs, "");
  }
}

}  // namespace laver::bench
