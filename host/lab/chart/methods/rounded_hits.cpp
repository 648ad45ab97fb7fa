#include "lab/chart/methods/rounded_hits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "bvh/walk.h"
#include "core/numeric.h"
#include "reference/ray.h"
#include "reference/rounding.h"

namespace laver::chart {
namespace {

using glm::dvec2;
using glm::dvec3;
constexpr double e = kUnitRoundoff;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double cross(dvec2 a, dvec2 b) { return a.x * b.y - a.y * b.x; }

/// A triangle relative to a ray: positions in the plane across the ray's dominant axis, depths
/// along it.
struct Seen {
  std::uint32_t id;
  std::array<dvec2, 3> p;
  std::array<double, 3> z;
  double bound = 0;     ///< of the movement of its edges by rounding
  double distance = 0;  ///< from the ray; 0 inside

  bool covers(dvec2 at) const {
    bool negative = false, positive = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const double side = cross(p[i] - at, p[(i + 1) % 3] - at);
      negative |= side < 0;
      positive |= side > 0;
    }
    return negative != positive;
  }
  /// Depth at a point, clamped between the corners' as in depthOf().
  double depth(dvec2 at) const {
    const double area = cross(p[1] - p[0], p[2] - p[0]);
    const auto [low, high] = std::minmax({z[0], z[1], z[2]});
    if (area == 0) return low;
    const double b = cross(at - p[0], p[2] - p[0]) / area, c = cross(p[1] - p[0], at - p[0]) / area;
    return std::clamp(z[0] + b * (z[1] - z[0]) + c * (z[2] - z[0]), low, high);
  }
  /// Error of depth(): the change under a sideways move by `reach`, and 8 e for the mean.
  double slack(double reach) const {
    const double area = std::abs(cross(p[1] - p[0], p[2] - p[0]));
    const auto [low, high] = std::minmax({z[0], z[1], z[2]});
    const dvec2 rise = (z[1] - z[0]) * (p[2] - p[0]) - (z[2] - z[0]) * (p[1] - p[0]);
    const double moved = reach * glm::length(rise);
    return std::min(moved, (high - low) * area) / std::max(area, 1e-300) +
           8.0 * e * std::max(std::abs(low), std::abs(high));
  }
};

Seen seenFrom(const shared::Triangle& triangle, const MethodRay& ray) {
  const dvec3 o(ray.origin), d(ray.direction);
  const reference::Shear shear({o, d});
  const double sign = shear.depth() < 0 ? -1.0 : 1.0;
  Seen seen{triangle.id, {}, {}};
  std::array<double, 3> off{};
  const std::array<dvec3, 3> corners{triangle.a, triangle.b, triangle.c};
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec3 at = shear(corners[i]);
    seen.p[i] = dvec2(at);
    seen.z[i] = at.z * sign;
    off[i] = cornerShift(corners[i] - o, d, seen.p[i]);
  }
  seen.distance = seen.covers(dvec2(0)) ? 0 : kInfinity;
  for (std::size_t i = 0; i < 3; ++i) {
    const dvec2 a = seen.p[i], b = seen.p[(i + 1) % 3], along = b - a;
    const double length = glm::length(along);
    seen.bound = std::max(seen.bound, std::max(off[i], off[(i + 1) % 3]) + edgeShift(a, b));
    const double share =
        length > 0 ? std::clamp(-glm::dot(a, along) / (length * length), 0.0, 1.0) : 0.0;
    seen.distance = std::min(seen.distance, glm::length(a + share * along));
  }
  return seen;
}

/// Triangles within their own bound of the ray and within its ends.
std::vector<Seen> nearRay(const Bvh& bvh, const MethodRay& ray) {
  const dvec3 o(ray.origin), d(ray.direction);
  const double scale = maxNorm(d);
  const double pad = 64.0 * e * (maxNorm(o) + 1.0);  // more than any bound
  std::vector<Seen> list;
  const auto passes = [&](const shared::Child& child) {
    double near = -kInfinity, far = kInfinity;
    for (int a = 0; a < 3; ++a) {
      const double t0 = (static_cast<double>(child.lo[a]) - pad - o[a]) / d[a];
      const double t1 = (static_cast<double>(child.hi[a]) + pad - o[a]) / d[a];
      near = std::max(near, std::min(t0, t1));
      far = std::min(far, std::max(t0, t1));
    }
    return !(near > far);
  };
  walk(bvh, 0, passes, [&](const shared::Triangle& triangle) {
    const Seen seen = seenFrom(triangle, ray);
    const auto [low, high] = std::minmax({seen.z[0], seen.z[1], seen.z[2]});
    if (seen.distance <= seen.bound && high >= static_cast<double>(ray.tmin) * scale &&
        low <= static_cast<double>(ray.tmax) * scale)
      list.push_back(seen);
    return false;
  });
  return list;
}

/// Clips a convex polygon to the regular polygon of 16 sides around the disc.
std::vector<dvec2> clipped(std::vector<dvec2> polygon, double radius) {
  for (int side = 0; side < 16 && !polygon.empty(); ++side) {
    const double angle = std::numbers::pi * side / 8.0;
    const dvec2 out(std::cos(angle), std::sin(angle));
    std::vector<dvec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      const double da = glm::dot(a, out) - radius, db = glm::dot(b, out) - radius;
      if (da <= 0) kept.push_back(a);
      if ((da < 0) != (db < 0) && da != db) kept.push_back(a + da / (da - db) * (b - a));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

/// Test points in a polygon: its centre, and points just inside and further from its corners and
/// sides.
std::vector<dvec2> pointsIn(const std::vector<dvec2>& polygon) {
  dvec2 middle(0);
  for (const dvec2 p : polygon) middle += p / static_cast<double>(polygon.size());
  std::vector<dvec2> points{middle};
  for (std::size_t i = 0; i < polygon.size(); ++i)
    for (const dvec2 to : {polygon[i], 0.5 * (polygon[i] + polygon[(i + 1) % polygon.size()])})
      for (const double share : {0.001, 0.25, 0.5}) points.push_back(glm::mix(to, middle, share));
  return points;
}

}  // namespace

bool RoundedHits::explains(const MethodRay& ray, std::uint32_t id) const {
  const std::vector<Seen> list = nearRay(bvh_, ray);
  double reach = 0;
  for (const Seen& seen : list) reach = std::max(reach, seen.bound);
  const auto hides = [&](const Seen& seen, dvec2 at, double depth) {
    return seen.id != id && seen.covers(at) && seen.depth(at) + seen.slack(reach) < depth;
  };
  const auto free = [&](dvec2 at, double depth) {
    return std::none_of(list.begin(), list.end(),
                        [&](const Seen& seen) { return hides(seen, at, depth); });
  };
  const std::vector<dvec2> disc = clipped({{-2 * reach, -2 * reach},
                                           {2 * reach, -2 * reach},
                                           {2 * reach, 2 * reach},
                                           {-2 * reach, 2 * reach}},
                                          reach);
  if (id == shared::NO_HIT) {
    const auto points = pointsIn(disc);
    return list.empty() ||
           std::any_of(points.begin(), points.end(), [&](dvec2 at) { return free(at, kInfinity); });
  }
  const auto own =
      std::find_if(list.begin(), list.end(), [&](const Seen& seen) { return seen.id == id; });
  if (own == list.end()) return false;
  const auto part = clipped({own->p.begin(), own->p.end()}, reach);
  if (part.empty()) return false;
  const auto points = pointsIn(part);
  return std::any_of(points.begin(), points.end(),
                     [&](dvec2 at) { return free(at, own->depth(at) - own->slack(reach)); });
}

}  // namespace laver::chart
