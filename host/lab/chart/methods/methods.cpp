#include "lab/chart/methods/methods.h"

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/numeric.h"
#include "lab/chart/methods/judge.h"
#include "lab/chart/numbers.h"
#include "render/packed.h"

namespace laver::chart {
namespace {

/// Names by the numbers of shared/charted.h.
constexpr const char* kTriangles[] = {"Moeller-Trumbore", "Woop, plain products", "Woop with Kahan",
                                      "ours"};
constexpr const char* kBoxes[] = {"plain slabs", "robust slabs", "ours"};
constexpr const char* kNodes[] = {"32 bits", "8 bits"};

/// Rays through the pixel centres, in tiles of 8 x 8 pixels, the order in which laver traces them.
std::vector<MethodRay> cameraRays(const Packed& data) {
  const shared::Params& p = data.params;
  const std::uint32_t width = p.filmSize.x, height = p.filmSize.y;
  std::vector<MethodRay> rays;
  for (std::uint32_t tileY = 0; tileY < height; tileY += 8)
    for (std::uint32_t tileX = 0; tileX < width; tileX += 8)
      for (std::uint32_t i = 0; i < 64; ++i) {
        const std::uint32_t x = tileX + i % 8, y = tileY + i / 8;
        if (x >= width || y >= height) continue;
        const float u = static_cast<float>(width) - 2.0F * (static_cast<float>(x) + 0.5F);
        const float v = static_cast<float>(height) - 2.0F * (static_cast<float>(y) + 0.5F);
        rays.push_back({p.origin, p.tmin, p.columnX * u + p.columnY * v + p.columnZ, p.tmax});
      }
  return rays;
}

}  // namespace

std::vector<MethodPoint> chartMethods(const Scene& scene, const std::string& device,
                                      std::size_t runs, const std::function<bool()>& stop) {
  if (hasSpheres(scene))
    throw Error(ExitCode::Usage,
                "its methods intersect triangles only, and the scene has a sphere");
  const Packed data = pack(scene, {}, uploadsOf(scene, {}));
  if (data.bvh.triangles.empty()) return {};
  MethodTracer tracer(device, data.bvh);
  MethodJudge camera(data.bvh), edges(data.bvh);
  const std::vector<MethodRay> rays = cameraRays(data), aimed = camera.aimed(rays);
  if (aimed.empty()) return {};
  camera.expect(rays);
  edges.expect(aimed);
  std::vector<MethodPoint> points;
  for (std::uint32_t t = 0; t < std::size(kTriangles); ++t)
    for (std::uint32_t b = 0; b < std::size(kBoxes); ++b)
      for (const bool quantised : {false, true}) {
        if (stop && stop()) return {};
        tracer.use({t, b, quantised});
        MethodPoint point{kTriangles[t], kBoxes[b], kNodes[quantised ? 1 : 0]};
        std::vector<double> nanoseconds;
        std::vector<MethodHit> hits;
        for (std::size_t run = 0; run <= runs; ++run) {
          double seconds = 0;
          hits = tracer.trace(rays, seconds);
          if (run > 0) nanoseconds.push_back(seconds * 1e9 / static_cast<double>(rays.size()));
        }
        point.nanoseconds = quantile(nanoseconds, 0.5);
        point.quartiles[0] = quantile(nanoseconds, 0.25);
        point.quartiles[1] = quantile(nanoseconds, 0.75);
        point.t99 = camera.t99(hits);
        point.normal99 = camera.normal99(hits);
        double unused = 0;
        point.rays = aimed.size();
        point.unexplained = edges.unexplained(tracer.trace(aimed, unused));
        points.push_back(point);
      }
  return points;
}

nlohmann::json toJson(const MethodPoint& m) {
  return {
      {"triangles", m.triangles},     {"boxes", m.boxes},         {"nodes", m.nodes},
      {"nanoseconds", m.nanoseconds}, {"quartiles", m.quartiles}, {"t99", m.t99},
      {"normal99", m.normal99},       {"rays", m.rays},           {"unexplained", m.unexplained}};
}

MethodPoint methodFromJson(const nlohmann::json& json) {
  MethodPoint m{json.at("triangles"), json.at("boxes"), json.at("nodes")};
  m.nanoseconds = json.at("nanoseconds");
  m.quartiles[0] = json.at("quartiles").at(0);
  m.quartiles[1] = json.at("quartiles").at(1);
  m.t99 = json.at("t99");
  m.normal99 = json.at("normal99");
  m.rays = json.at("rays");
  m.unexplained = json.at("unexplained");
  return m;
}

}  // namespace laver::chart
