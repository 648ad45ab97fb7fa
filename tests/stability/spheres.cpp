// Spheres far, huge, tiny and grazing, from outside and inside, against 113-bit arithmetic, and the
// textbook quadratic.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "stability/exact.h"
#include "stability/record.h"
#include "stability/statistics.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::test {
namespace {

using exact::Quad;
using glm::dvec3;
using glm::vec3;

shared::Triangle sphereOf(vec3 centre, float radius, std::uint32_t id) {
  return {centre, id, vec3(radius), 0, vec3(0.0F), shared::IS_SPHERE};
}

/// The exact relation of a ray's line, given in floats, to a sphere.
struct Truth {
  Quad apart;         // distance of the line from the centre
  Quad enter, leave;  // t
  double cosine;      // of the incidence where it enters
  dvec3 normal;       // there
};

Quad rootOf(Quad x) {
  if (x <= 0) return 0;
  auto r =
      static_cast<Quad>(std::sqrt(static_cast<double>(x)));  // Newton's method extends its 53 bits
  for (int i = 0; i < 3; ++i) r = (r + x / r) / 2;
  return r;
}

Truth truthOf(vec3 origin, vec3 direction, vec3 centre, float radius) {
  Quad f[3], a = 0, b = 0;
  for (int i = 0; i < 3; ++i) {
    f[i] = Quad(origin[i]) - Quad(centre[i]);
    a += Quad(direction[i]) * Quad(direction[i]);
    b -= f[i] * Quad(direction[i]);
  }
  Quad square = 0;
  for (int i = 0; i < 3; ++i) {
    const Quad l = f[i] + b / a * Quad(direction[i]);
    square += l * l;
  }
  const Quad half = rootOf((Quad(radius) * Quad(radius) - square) / a);
  Truth truth{rootOf(square), b / a - half, b / a + half, 0.0, {}};
  const Quad t = truth.enter >= 0 ? truth.enter : truth.leave;
  for (int i = 0; i < 3; ++i)
    truth.normal[i] = static_cast<double>((f[i] + t * Quad(direction[i])) / Quad(radius));
  truth.cosine = std::abs(glm::dot(truth.normal, glm::normalize(dvec3(direction))));
  return truth;
}

/// t of the first hit beyond `mint` by b^2 - 4 a c in float; infinite for none.
float textbook(vec3 origin, vec3 direction, vec3 centre, float radius, float mint) {
  const vec3 f = origin - centre;
  const float a = glm::dot(direction, direction), b = 2.0F * glm::dot(f, direction);
  const float rest = b * b - 4.0F * a * (glm::dot(f, f) - radius * radius);
  if (rest < 0.0F) return INFINITY;
  const float near = (-b - std::sqrt(rest)) / (2.0F * a), far = (-b + std::sqrt(rest)) / (2.0F * a);
  return near > mint ? near : far > mint ? far : INFINITY;
}

struct Setting {
  const char* name;
  float radius, distance;  // of the origin from the centre; below the radius: inside
  vec3 centre;
};

const Setting kSettings[] = {{"near, radius 0.5 from 2", 0.5F, 2.0F, vec3(0.1F, -0.2F, 0.3F)},
                             {"far, radius 0.5 from 1,000", 0.5F, 1000.0F, vec3(0.1F, -0.2F, 0.3F)},
                             {"tiny, radius 1e-4 from 2", 1e-4F, 2.0F, vec3(0.7F, -0.2F, 0.3F)},
                             {"huge, radius 1 from 1e-4 above", 1.0F, 1.0001F, vec3(0.0F)},
                             {"inside, radius 1 from 1e-5 below", 1.0F, 0.99999F, vec3(0.0F)}};

/// Blocks of 64 rays with a common origin, aimed at points of the sphere's visible disc, up to
/// `edge` radii from its centre; from inside and from close above, in all directions.
std::vector<TestRay> raysAt(const Setting& s, std::uint64_t count, double edge) {
  std::mt19937 random(18);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto anyWay = [&] {
    return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
  };
  std::vector<TestRay> rays;
  vec3 origin(0.0F);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (i % 64 == 0) origin = vec3(dvec3(s.centre) + static_cast<double>(s.distance) * anyWay());
    const dvec3 back = dvec3(s.centre) - dvec3(origin);
    const dvec3 side = glm::normalize(glm::cross(back, anyWay()));
    const double offset = edge * std::sqrt(unit(random)) * static_cast<double>(s.radius);
    const dvec3 aim = static_cast<double>(s.distance) < 1.5 * static_cast<double>(s.radius)
                          ? anyWay()
                          : back + offset * side;
    rays.push_back(rayOf(origin, vec3(aim)));
  }
  return rays;
}

struct Errors {
  std::vector<double> t, normal;
  std::uint64_t outline = 0;
};

/// Errors of the hits at one sphere: wrong hits at the outline beyond the bound of sphere.h, t in
/// ulp where the incidence is steep enough, and for a twin the normal in units of 2^-24.
template <class HitOf>
Errors judge(const Setting& s, const std::vector<TestRay>& rays, const Twin* twin,
             const shared::Triangle& sphere, const HitOf& hitOf) {
  Errors errors;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const vec3 o = rays[i].origin, d = rays[i].direction;
    const Truth truth = truthOf(o, d, s.centre, s.radius);
    const float t = hitOf(i);
    const bool hit = t < 1e36F;
    const bool met = truth.apart <= Quad(s.radius) && truth.leave >= 0;
    // Bound: 16 e A for the line, 5 e radius for the outline (box.h, sphere.h).
    const vec3 size = glm::abs(s.centre) + s.radius;
    const double bound = static_cast<double>(shared::padOf(o)) +
                         16 * 0x1p-24 * static_cast<double>(std::max({size.x, size.y, size.z})) +
                         8 * 0x1p-24 * static_cast<double>(s.radius);
    const double off = std::abs(static_cast<double>(truth.apart - Quad(s.radius)));
    if (hit != met) {
      // For an origin on the surface the ends of the chord matter, too.
      const double end = std::abs(static_cast<double>(truth.leave)) * glm::length(dvec3(d));
      errors.outline += off > bound && end > bound ? 1 : 0;
      continue;
    }
    if (!hit || truth.cosine < 0.1) continue;
    const Quad wanted = truth.enter >= 0 ? truth.enter : truth.leave;
    errors.t.push_back(ulps(t, static_cast<double>(wanted)));
    if (twin == nullptr) continue;
    const shared::Point p = twin->point(o, d, sphere);
    errors.normal.push_back(glm::length(dvec3(p.geometric) - truth.normal) / 0x1p-24);
  }
  return errors;
}

LAVER_STABILITY(Spheres, "Spheres: far, huge, tiny, grazing, from inside") {
  for (const Setting& s : kSettings) {
    const std::vector<shared::Triangle> spheres{sphereOf(s.centre, s.radius, 0)};
    const Bvh bvh = buildBvh(spheres);
    const auto rays = raysAt(s, amount(full, 1U << 16, 1U << 20), 1.1);
    const Errors naive = judge(s, rays, nullptr, spheres[0], [&](std::size_t i) {
      const float t = textbook(rays[i].origin, rays[i].direction, s.centre, s.radius, 1e-4F);
      return std::isfinite(t) ? t : 1e37F;
    });
    for (const auto& subject : subjects(bvh)) {
      const auto hits = subject->closest(rays);
      const Errors ours =
          judge(s, rays, subject->twin, spheres[0], [&](std::size_t i) { return hits[i].t; });
      const bool fails = naive.outline > 0;
      record.add({fmt::format("outline: {}", s.name), subject->name, rays.size(),
                  fails ? std::optional(static_cast<double>(naive.outline)) : std::nullopt,
                  static_cast<double>(ours.outline), 0.0, "rays"});
      // The same bound as in the case Slivers.
      record.add({fmt::format("t, 99th percentile at cos > 0.1: {}", s.name), subject->name,
                  ours.t.size(), percentile(naive.t, 0.99), percentile(ours.t, 0.99), 4.0, "ulp"});
      if (subject->twin != nullptr)
        record.add({fmt::format("normal, 99th percentile: {}", s.name), subject->name,
                    ours.normal.size(), std::nullopt, percentile(ours.normal, 0.99), 4.0, "2^-24"});
    }
  }
}

/// Points of a sphere hit by camera rays that face the light.
std::vector<vec3> litPoints(Subject& subject, const Bvh& bvh, const Setting& s, vec3 light,
                            const std::vector<TestRay>& rays) {
  const auto hits = subject.closest(rays);
  std::vector<vec3> points;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (hits[i].id == shared::NO_HIT) continue;
    const Truth truth = truthOf(rays[i].origin, rays[i].direction, s.centre, s.radius);
    const dvec3 p = dvec3(s.centre) + truth.normal * static_cast<double>(s.radius);
    // The rounding of a point tilts its horizon by e (|centre| + radius) / radius.
    const double level =
        64 * 0x1p-24 * (1.0 + glm::length(dvec3(s.centre)) / static_cast<double>(s.radius));
    if (glm::dot(truth.normal, glm::normalize(dvec3(light) - p)) > level)
      points.push_back(shadowPoint(subject, bvh, rays[i], 0, light));
  }
  return points;
}

LAVER_STABILITY(SphereShadows, "Spheres shade neither themselves nor nothing") {
  const vec3 towards = glm::normalize(vec3(0.5F, 0.7F, -0.3F));
  for (const Setting& s : {kSettings[0], kSettings[1], kSettings[2],
                           Setting{"radius 1 from 3", 1.0F, 3.0F, vec3(0.0F)}}) {
    const Bvh bvh = buildBvh(std::vector{sphereOf(s.centre, s.radius, 0)});
    const auto rays = raysAt(s, amount(full, 1U << 14, 1U << 18), 1.0);
    for (const float distance : {1.5F, 1e2F, 1e4F}) {
      const vec3 light = s.centre + towards * distance;
      std::uint64_t naive = 0;
      for (const TestRay& r : rays) {  // as in Acne: a scene of a thousand units, mint 1e-4
        const float k = 1e3F;
        const vec3 d = glm::normalize(r.direction);
        const float t = textbook(r.origin * k, d, s.centre * k, s.radius * k, 1e-4F);
        if (!std::isfinite(t)) continue;
        const vec3 p = r.origin * k + d * t, n = glm::normalize(p - s.centre * k);
        const vec3 direction = glm::normalize(light * k - p);
        if (glm::dot(n, direction) <= 1e-3F) continue;
        naive += std::isfinite(textbook(p, direction, s.centre * k, s.radius * k, 1e-4F)) ? 1 : 0;
      }
      for (const auto& subject : subjects(bvh)) {
        const auto points = litPoints(*subject, bvh, s, light, rays);
        EXPECT_GT(points.size(), rays.size() / 20);
        const auto seen = subject->visible(light, points);
        record.add({fmt::format("{}, light {:g} off", s.name, static_cast<double>(distance)),
                    subject->name, points.size(),
                    naive > 0 ? std::optional(static_cast<double>(naive)) : std::nullopt,
                    static_cast<double>(std::count(seen.begin(), seen.end(), 0U)), 0.0,
                    "false shadows"});
      }
    }
  }
}

LAVER_STABILITY(SphereContact, "Spheres that touch cast their whole shadow") {
  // One sphere stands on the other, 0, 1 or 8 ulp above or inside it; the light is overhead.
  const float radius = 0.5F;
  for (const int ulps : {-8, -1, 0, 1, 8}) {
    const vec3 low(0.0F, -0.5F, 0.0F);
    const vec3 high(0.0F, 0.5F + static_cast<float>(ulps) * 0x1p-24F, 0.0F);
    const std::vector<shared::Triangle> spheres{sphereOf(low, radius, 0),
                                                sphereOf(high, radius, 1)};
    const Bvh bvh = buildBvh(spheres);
    const vec3 light(0.0F, 3.0F, 0.0F);
    std::mt19937 random(20);
    std::uniform_real_distribution<float> place(-0.02F, 0.02F);
    std::vector<TestRay> rays;
    for (int i = 0; i < 64 * 64; ++i) {  // to the top of the lower sphere, where y = -(x^2 + z^2)
      const float x = place(random), z = place(random);
      rays.push_back(rayOf(vec3(1.0F, 0.0F, 0.2F), vec3(x - 1.0F, -(x * x + z * z), z - 0.2F)));
    }
    for (const auto& subject : subjects(bvh)) {
      const auto hits = subject->closest(rays);
      std::vector<vec3> points;
      for (std::size_t i = 0; i < rays.size(); ++i)
        if (hits[i].id == 0) points.push_back(shadowPoint(*subject, bvh, rays[i], 0, light));
      EXPECT_GT(points.size(), 100U);
      const auto seen = subject->visible(light, points);
      record.add({fmt::format("{} ulp apart", ulps), subject->name, points.size(), std::nullopt,
                  static_cast<double>(std::count(seen.begin(), seen.end(), 1U)), 0.0,
                  "points that see the light"});
    }
  }
}

}  // namespace
}  // namespace laver::test
