#include <fmt/format.h>

#include <functional>
#include <map>
#include <tuple>

#include "bench/bench.h"
#include "bench/embree_rays.h"
#include "bench/ray_sets.h"
#include "bench/scenes.h"
#include "render/traversal.h"
#include "vulkan/instance.h"

namespace laver::bench {
namespace {

/// One mesh as an Embree scene for each kind of call.
struct EmbreeScenes {
  EmbreeScenes(const EmbreeDevices& devices, const Scene& scene)
      : mesh(scene),
        robust(devices.native, mesh, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_MEDIUM),
        plain(devices.native, mesh, RTC_SCENE_FLAG_NONE, RTC_BUILD_QUALITY_MEDIUM),
        robustAvx2(devices.avx2, mesh, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_MEDIUM) {}
  EmbreeMesh mesh;
  EmbreeScene robust, plain, robustAvx2;
};

/// laver's kernels and Embree's calls on one set of rays, measured alternately.
class Contest {
 public:
  explicit Contest(std::size_t rounds) : rounds_(rounds) {}

  /// `once` runs once and returns seconds.
  void add(const std::string& name, std::function<double()> once) {
    runs_.push_back({name, std::move(once), {}});
  }

  /// Prints each relative to the first, and returns the medians.
  std::map<std::string, double> finish(Report& report, double rays) {
    for (std::size_t round = 0; round <= rounds_; ++round)
      for (Run& run : runs_) {
        const double seconds = run.once();
        if (round > 0) run.seconds.push_back(seconds);
      }
    std::map<std::string, double> medians;
    for (const Run& run : runs_) {
      medians[run.name] = median(run.seconds);
      report.timing(run.name, run.seconds, rays, &run == runs_.data() ? 0 : medians[runs_[0].name]);
    }
    return medians;
  }

 private:
  struct Run {
    std::string name;
    std::function<double()> once;
    std::vector<double> seconds;
  };
  std::size_t rounds_;
  std::vector<Run> runs_;
};

double differingIds(const std::vector<TestHit>& a, const std::vector<TestHit>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) count += a[i].id != b[i].id ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(a.size());
}

double hitShare(const std::vector<TestHit>& hits) {
  std::size_t count = 0;
  for (const TestHit& hit : hits) count += hit.id != shared::NO_HIT ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(hits.size());
}

struct Tracers {
  test::RayTracer lane, packet;
};

std::map<std::string, double> coherent(Report& report, const std::string& name, Tracers& laver,
                                       const EmbreeScenes& e, std::span<const TestRay> rays,
                                       std::size_t rounds) {
  EmbreeRays embree(rays, {});
  const auto hits = laver.packet.closest(rays);
  embree.closest(e.robust.get(), 16, true, 2);
  report.section("Traversal only: " + name + ", primary, 2 threads",
                 {{"hits", hitShare(hits)},
                  {"rays", rays.size()},
                  {"not traced to the end", laver.packet.incomplete()},
                  {"differing ids, ray16 robust", differingIds(hits, embree.hits())}});
  Contest contest(rounds);
  const auto ours = [&](test::RayTracer& tracer) {
    return [&] { return tracer.closest(rays), tracer.seconds(); };
  };
  const auto theirs = [&](const EmbreeScene& scene, int width) {
    return [&embree, &scene, width] { return embree.closest(scene.get(), width, true, 2); };
  };
  contest.add("laver packets", ours(laver.packet));
  contest.add("laver lane", ours(laver.lane));
  contest.add("ray16 robust", theirs(e.robust, 16));
  contest.add("ray16", theirs(e.plain, 16));
  contest.add("ray16 robust avx2", theirs(e.robustAvx2, 16));
  contest.add("ray8 robust", theirs(e.robust, 8));
  contest.add("ray8 robust avx2", theirs(e.robustAvx2, 8));
  contest.add("ray1 robust", theirs(e.robust, 1));
  contest.add("ray1 robust avx2", theirs(e.robustAvx2, 1));
  return contest.finish(report, static_cast<double>(rays.size()));
}

std::map<std::string, double> shadow(Report& report, const std::string& name, Tracers& laver,
                                     const EmbreeScenes& e, glm::vec3 light,
                                     std::span<const glm::vec3> points, std::size_t rounds) {
  EmbreeRays embree({}, points);
  const auto seen = laver.packet.visible(light, points);
  embree.visible(e.robust.get(), 16, light, 2);
  const auto others = embree.seen();
  std::size_t traced = 0, lit = 0, differ = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    traced += points[i].x == points[i].x ? 1 : 0;
    lit += seen[i];
    differ += seen[i] != others[i] ? 1 : 0;
  }
  const auto rays = static_cast<double>(traced);
  report.section("Traversal only: " + name + ", shadow, 2 threads",
                 {{"lit", static_cast<double>(lit) / rays},
                  {"rays", traced},
                  {"not traced to the end", laver.packet.incomplete()},
                  {"differing, ray16 robust", static_cast<double>(differ) / rays}});
  Contest contest(rounds);
  const auto ours = [&](test::RayTracer& tracer) {
    return [&] { return tracer.visible(light, points), tracer.seconds(); };
  };
  const auto theirs = [&](const EmbreeScene& scene, int width) {
    return [&embree, &scene, width, light] { return embree.visible(scene.get(), width, light, 2); };
  };
  contest.add("laver packets", ours(laver.packet));
  contest.add("laver lane", ours(laver.lane));
  contest.add("occluded16 robust", theirs(e.robust, 16));
  contest.add("occluded16 robust avx2", theirs(e.robustAvx2, 16));
  contest.add("occluded8 robust", theirs(e.robust, 8));
  contest.add("occluded1 robust", theirs(e.robust, 1));
  return contest.finish(report, rays);
}

/// Incoherent rays: `lane` against rtcIntersect1.
void incoherent(Report& report, const std::string& name, test::RayTracer& lane,
                const EmbreeScenes& e, std::span<const TestRay> rays, std::size_t rounds) {
  EmbreeRays embree(rays, {});
  const auto hits = lane.closest(rays);
  embree.closest(e.robust.get(), 1, false, 2);
  report.section("Traversal only: " + name + ", 2 threads",
                 {{"hits", hitShare(hits)},
                  {"rays", rays.size()},
                  {"differing ids, ray1 robust", differingIds(hits, embree.hits())}});
  Contest contest(rounds);
  contest.add("laver lane", [&] { return lane.closest(rays), lane.seconds(); });
  for (const auto& [call, scene, width] :
       {std::tuple("ray1 robust", &e.robust, 1), std::tuple("ray1 robust avx2", &e.robustAvx2, 1),
        std::tuple("ray16 robust", &e.robust, 16)})
    contest.add(call,
                [&embree, s = scene->get(), w = width] { return embree.closest(s, w, false, 2); });
  contest.finish(report, static_cast<double>(rays.size()));
}

}  // namespace

void benchRays(Report& report, const EmbreeDevices& devices, const Rounds& rounds) {
  ::setenv("LP_NUM_THREADS", "2", 1);
  const Instance instance(false);
  const Device device(choosePhysicalDevice(instance, "cpu"));
  for (const int subdivided : {0, 2}) {
    if (rounds.brief && subdivided > 0) continue;
    const Scene scene = benchScene("bunny", subdivided, "direct_whitted", 1);
    const Packed data = pack(scene, {}, uploadsOf(scene, {}));
    const EmbreeScenes embree(devices, scene);
    Tracers laver{{device, data.bvh, "lane"},
                  {device, data.bvh, traversalName(fasterPackets(scene))}};
    const std::string title = titleOf("bunny", subdivided);
    const auto rays = cameraRays(data);
    const auto hits = laver.lane.closest(rays);
    const auto first = coherent(report, title, laver, embree, rays, rounds.passes);
    const auto second = shadow(report, title, laver, embree, data.lights.front().position,
                               litPoints(data, rays, hits), rounds.passes);
    const std::size_t few = std::max<std::size_t>(rounds.passes / 3, 1);
    incoherent(report, title + ", shuffled camera rays", laver.lane, embree, shuffled(rays), few);
    incoherent(report, title + ", bounced rays", laver.lane, embree, bounced(data, rays, hits),
               few);
    report.figure(title + ": camera rays, rtcIntersect16 robust / laver packets",
                  first.at("ray16 robust") / first.at("laver packets"), "");
    report.figure(title + ": camera rays, rtcIntersect1 robust / laver lane",
                  first.at("ray1 robust") / first.at("laver lane"), "");
    report.figure(title + ": shadow rays, rtcOccluded16 robust / laver packets",
                  second.at("occluded16 robust") / second.at("laver packets"), "");
  }
}

}  // namespace laver::bench
