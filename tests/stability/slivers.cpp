// Errors of distances at slivers and at grazing incidence, in ulp, and the stated bounds for
// distances and normals.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>

#include "stability/exact.h"
#include "stability/meshes.h"
#include "stability/naive.h"
#include "stability/record.h"
#include "stability/sliver_rays.h"
#include "stability/statistics.h"
#include "stability/subject.h"

namespace laver::test {
namespace {

constexpr double kAspects[] = {1.0, 1e2, 1e3, 1e4, 1e5, 1e6};

/// Errors of many rays at one kind of triangle.
struct Errors {
  std::vector<double> naiveT, t, normal, shading, radiance;
};

/// Angle between unit vectors in units of 2^-24, about an ulp of a component.
double angle(glm::vec3 value, glm::dvec3 truth) {
  return glm::length(glm::dvec3(value) - truth) / 0x1p-24;
}

/// cos / d^2, in the precision of its arguments.
float lambert(glm::vec3 light, glm::vec3 position, glm::vec3 normal) {
  const glm::vec3 direction = light - position;
  const float squared = shared::dotProduct(direction, direction);
  return 1.0F / squared * (shared::dotProduct(normal, direction) / std::sqrt(squared));
}
double lambert(const glm::dvec3& light, const glm::dvec3& position, const glm::dvec3& normal) {
  const glm::dvec3 direction = light - position;
  const double squared = glm::dot(direction, direction);
  return glm::dot(normal, direction) / std::sqrt(squared) / squared;
}

/// Errors at single triangles, by the twin's pointAt(). The table's last columns are informative;
/// only t is judged.
Errors errorsOf(const Twin& twin, double aspect, double distance, double minCosine,
                double maxCosine, std::uint64_t count) {
  Errors all;
  std::mutex mutex;
  forBatches(count, 1024, 9, [&](std::uint64_t, std::mt19937& random) {
    Errors own;
    for (int i = 0; i < 1024; ++i) {
      const SliverRay s = sliverRay(aspect, distance, minCosine, maxCosine, random);
      const auto truth = exact::planeHit(s.ray.origin, s.ray.direction, s.triangle);
      if (!truth.inside || truth.cosine < minCosine || truth.cosine > maxCosine) continue;
      // pointAt() is only defined where the kernel accepts the hit.
      if (!twin.inside(s.ray.origin, s.ray.direction, s.triangle)) continue;
      const shared::Point p = twin.point(s.ray.origin, s.ray.direction, s.triangle);
      own.t.push_back(exact::ulps(p.t, truth.t));
      own.normal.push_back(angle(p.geometric, exact::normal(s.triangle)));
      // Vertex normals a few degrees apart, as on a smooth mesh.
      const auto vertexNormal = [&](double x, double y) {
        const glm::dvec3 n = exact::normal(s.triangle);
        return glm::vec3(glm::normalize(n + glm::dvec3(x, y, x - y)));
      };
      const glm::vec3 na = vertexNormal(0.05, 0.0), nb = vertexNormal(0.0, -0.04);
      const glm::vec3 nc = vertexNormal(-0.03, 0.02);
      const glm::dvec3 w = exact::weights(s.ray.origin, s.ray.direction, s.triangle);
      const glm::vec3 shading = shared::shadingNormal(p, na, nb, nc);
      const glm::dvec3 trueShading =
          glm::normalize(w.x * glm::dvec3(na) + w.y * glm::dvec3(nb) + w.z * glm::dvec3(nc));
      own.shading.push_back(angle(shading, trueShading));
      // A light at 3 along the plane's normal and 1 sideways, by the formula of
      // direct_whitted.glsl.
      const glm::dvec3 position = glm::dvec3(s.ray.origin) + truth.t * glm::dvec3(s.ray.direction);
      const glm::vec3 light(position + 3.0 * exact::normal(s.triangle) +
                            glm::dvec3(na - nb) * 10.0);
      own.radiance.push_back(exact::ulps(lambert(light, p.position, shading),
                                         lambert(glm::dvec3(light), position, trueShading)));
      TestHit hit{};
      if (naive::moellerTrumbore(s.ray.origin, s.ray.direction, s.triangle, 0.0F, 1e37F, hit))
        own.naiveT.push_back(exact::ulps(hit.t, truth.t));
    }
    const std::lock_guard lock(mutex);
    const auto append = [](auto& to, const auto& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(all.t, own.t);
    append(all.normal, own.normal);
    append(all.shading, own.shading);
    append(all.radiance, own.radiance);
    append(all.naiveT, own.naiveT);
  });
  return all;
}

/// The largest error of each kind divided by its stated bound. Bounds, for triangles of
/// longest edge 0.1 in a scene of half-width 1, seen at no less than cosine c from `distance`:
///   t         p99 0.4 / c ulp, as measured; at most 23 / c ulp, with e = 2^-24, w = a - o and
///             |w| <= 1.5 t |d|: components of n err by 4 e, w by e, a dot product by 3 e of its
///             absolute terms, so n . w by 8 e |n| |w| and n . d by 7 e |n| |d|, of |n| t |d| c and
///             |n| |d| c; rounded edges move the plane by e / c of t; 3 e for what follows
///   normal    3 + 2 aspect, in 2^-24: corners' differences round, over the height
///   shading   8 + 2 aspect max(distance, 1) / c: so do weights, along the surface
///   radiance  8 + a quarter of the shading normal's
struct Shares {
  double naiveT = 0, t = 0, normal = 0, shading = 0, radiance = 0;

  void add(const Errors& e, double aspect, double distance, double cosine) {
    const double turn = 2.0 * aspect * std::max(distance, 1.0) / cosine;
    const auto raise = [](double& share, double value, double bound) {
      share = std::max(share, value / bound);
    };
    raise(t, percentile(e.t, 0.99), 0.4 / cosine);
    raise(t, maximum(e.t), 23.0 / cosine);
    raise(naiveT, maximum(e.naiveT), 23.0 / cosine);
    raise(normal, maximum(e.normal), 3.0 + 2.0 * aspect);
    raise(shading, maximum(e.shading), 8.0 + turn);
    raise(radiance, maximum(e.radiance), 8.0 + 0.25 * turn);
  }
};

/// Slivers in one tree; each is hit by a ray that starts and ends near it.
struct SliverField {
  Bvh bvh;
  std::vector<TestRay> rays;   ///< 64 copies for each triangle, in the order of the ids
  std::vector<double> truths;  ///< t
};

SliverField sliverField(double aspect, std::uint64_t count) {
  std::mt19937 random(static_cast<std::uint32_t>(aspect));
  SliverField field;
  std::vector<shared::Triangle> triangles;
  while (triangles.size() < count) {
    SliverRay s = sliverRay(aspect, 2.0, 0.1, 1.0, random);
    const auto truth = exact::planeHit(s.ray.origin, s.ray.direction, s.triangle);
    if (!truth.inside || truth.cosine < 0.1) continue;
    s.triangle.id = static_cast<std::uint32_t>(triangles.size());
    triangles.push_back(s.triangle);
    s.ray.tmin = static_cast<float>(truth.t * 0.999);
    s.ray.tmax = static_cast<float>(truth.t * 1.001);
    field.rays.insert(field.rays.end(), 64, s.ray);
    field.truths.push_back(truth.t);
  }
  field.bvh = buildBvh(triangles);
  return field;
}

std::vector<double> errorsOf(Subject& subject, const SliverField& field) {
  const auto hits = subject.closest(field.rays);
  std::vector<double> errors;
  for (std::size_t i = 0; i < field.truths.size(); ++i)
    if (hits[64 * i].id == i) errors.push_back(exact::ulps(hits[64 * i].t, field.truths[i]));
  return errors;
}

LAVER_STABILITY(Slivers, "Slivers of aspect 1e2 to 1e6, and grazing incidence") {
  // As many in slow builds, too: a percentile of fewer would exceed its bound.
  const std::uint64_t count = full ? 1ULL << 20 : 1ULL << 16;
  for (const double aspect : kAspects) {
    if (aspect == 1.0) continue;
    double naiveError = 0;
    for (const Twin* twin : twins()) {
      const Errors e = errorsOf(*twin, aspect, 2.0, 0.1, 1.0, count);
      naiveError = percentile(e.naiveT, 0.99);
      EXPECT_GT(e.t.size(), count / 4);
      record.add({fmt::format("p99 of t, aspect {:.0e}, cos > 0.1", aspect), twin->name, e.t.size(),
                  naiveError, percentile(e.t, 0.99), 4.0, "ulp"});
    }
    const SliverField field = sliverField(aspect, full ? 1ULL << 16 : 1ULL << 14);
    for (const auto& subject : subjects(field.bvh)) {
      if (subject->twin != nullptr) continue;  // judged above
      const auto errors = errorsOf(*subject, field);
      record.add({fmt::format("p99 of t, aspect {:.0e}, cos > 0.1", aspect), subject->name,
                  errors.size(), naiveError, percentile(errors, 0.99), 4.0, "ulp"});
    }
  }

  for (const Twin* twin : twins()) {
    if (std::string(twin->name) == "C++ -O0") continue;
    const bool shown = twin == twins()[1];
    Shares shares;
    std::uint64_t rays = 0;
    const auto line = [&](const std::string& head, double aspect, double distance, double minCosine,
                          double maxCosine) {
      const Errors e = errorsOf(*twin, aspect, distance, minCosine, maxCosine, count);
      shares.add(e, aspect, distance, minCosine);
      rays += e.t.size();
      return std::vector<std::string>{head,
                                      bounds(e.t),
                                      bounds(e.normal),
                                      bounds(e.shading),
                                      bounds(e.radiance),
                                      bounds(e.naiveT)};
    };
    const auto table = [&](const char* first) {
      return std::vector<std::vector<std::string>>{{first, "t [ulp]", "normal [2^-24]",
                                                    "shading normal [2^-24]", "radiance [ulp]",
                                                    "t, naive [ulp]"}};
    };
    auto cells = table("aspect");
    for (const double aspect : kAspects)
      cells.push_back(line(fmt::format("{:.0e}", aspect), aspect, 2.0, 0.1, 1.0));
    if (shown) record.table("Error by aspect ratio, p99 / max, distance 2, cos > 0.1", cells);
    cells = table("cos");
    for (const double maxCosine : {1.0, 0.1, 0.01, 0.001})
      cells.push_back(line(fmt::format("{:.0e} to {:.0e}", 0.1 * maxCosine, maxCosine), 10.0, 2.0,
                           0.1 * maxCosine, maxCosine));
    if (shown) record.table("Error by incidence, p99 / max, aspect 10, distance 2", cells);
    cells = table("distance");
    for (const double distance : {0.2, 2.0, 20.0, 200.0, 2000.0})
      cells.push_back(line(fmt::format("{}", distance), 10.0, distance, 0.1, 1.0));
    if (shown) record.table("Error by distance, p99 / max, aspect 10, cos > 0.1", cells);
    record.add(
        {"stated bounds, t", twin->name, rays, shares.naiveT, shares.t, 1.0, "of the bound"});
    for (const auto& [name, share] :
         {std::pair("normal", shares.normal), std::pair("shading normal", shares.shading),
          std::pair("radiance", shares.radiance)})
      record.add({std::string("stated bounds, ") + name, twin->name, rays, std::nullopt, share, 1.0,
                  "of the bound", 0.0});
  }
}

}  // namespace
}  // namespace laver::test
