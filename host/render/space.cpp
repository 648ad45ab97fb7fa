#include "render/space.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "render/visible.h"

namespace laver {
namespace {

using glm::dvec3;
constexpr double e = 0x1p-24;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Radians per pixel below which rays start near the scene. A direction errs by some 13 e with the
/// origin's rounding (reference/rounding.h): by 1/64 of such a pixel. Films of 8,192 columns over
/// 23 degrees are wider.
constexpr double kNarrowPixel = 13.0 * 64.0 * e;

/// Of the farthest part of a scene to the nearest: products of three coordinates stay below 2^127.
constexpr double kLargestSpan = 0x1p36;

/// Pixels by which a picture may be off before it is refused.
constexpr double kWorst = 0.5;

int floorLog2(double x) { return std::ilogb(x); }

double powerOfTwo(int exponent) { return std::ldexp(1.0, std::clamp(exponent, -1000, 1000)); }

dvec3 centreOf(const Bounds& box) { return box.lo * 0.5 + box.hi * 0.5; }
dvec3 halfOf(const Bounds& box) { return box.hi * 0.5 - box.lo * 0.5; }

/// The largest distance of a corner of the box from a point.
double farthestFrom(dvec3 p, const Bounds& box) {
  return glm::length(glm::max(glm::abs(box.lo - p), glm::abs(box.hi - p)));
}

Normalisation ordinary(const Bounds& box) {
  Normalisation space;
  space.centre = centreOf(box);
  const dvec3 half = halfOf(box);
  const double largest = std::max({half.x, half.y, half.z});
  // Half-width in (1/2, 1) for any scene of a representable size.
  if (largest > 0.0) space.scale = powerOfTwo(-1 - floorLog2(largest));
  return space;
}

/// Eight units lie between 1/2 and 1, so that what is near is of about unit size.
Normalisation around(dvec3 centre, double unit, const Bounds& box) {
  Normalisation space;
  space.centre = centre;
  const double far = farthestFrom(centre, box);
  space.unit = std::max(unit, far / kLargestSpan);
  space.scale = powerOfTwo(-1 - floorLog2(8.0 * space.unit));
  space.reach = std::max(4.0, 2.0 * far * space.scale);
  return space;
}

void refuseBeyond(double pixels, double nearest, double farthest) {
  if (!(pixels > kWorst)) return;
  throw Error(ExitCode::Device,
              fmt::format("the camera sees things {:.3g} to {:.3g} away: floats of the device "
                          "would place them only to {:.2g} pixels",
                          nearest, farthest, pixels));
}

/// Rays start before what is visible.
Normalisation narrow(const Visible& visible, const Bounds& box) {
  const DepthRange seen = visible.range(kInfinity);
  if (!(seen.near < kInfinity)) return ordinary(box);
  const double width = visible.halfWidth() * seen.near + visible.lensWidth();
  const double budget =
      std::min(kOrdinaryReach * width, visible.pixel() * seen.near / (64.0 * 6.0 * e));
  Normalisation space = ordinary(box);
  if (glm::length(halfOf(box)) > budget) {
    space = around(visible.onAxis(seen.near), width, box);
    refuseBeyond(8.0 * e * (1.0 - seen.near / seen.far) / visible.pixel(), seen.near, seen.far);
  }
  space.start = visible.cameraDepth(std::max(seen.near - width, 0.0));
  return space;
}

/// Corners a, b, c: with u = b - a and v = c - a, component i of u x v errs by e (|u_j v_k| + |u_k
/// v_j|), and the side of a point on the triangle by that times its distance from a along i. Rays
/// start 8 e |n| . max |corner| above the plane (shared/point.h): a triangle is narrow where the
/// bound of that error is larger. Tilted discs show errors from 20 e, and none at 13 e.
bool isSliver(const std::array<dvec3, 3>& corners, const Normalisation& space) {
  const dvec3 u = glm::abs(corners[1] - corners[0]), v = glm::abs(corners[2] - corners[0]);
  const dvec3 n = glm::abs(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  const dvec3 products(u.y * v.z + u.z * v.y, u.z * v.x + u.x * v.z, u.x * v.y + u.y * v.x);
  // Of a split triangle, no piece extends farther than some of its distance from the centre.
  const dvec3 extent = glm::max(u, v);
  dvec3 largest = extent;
  if (!space.wide()) {
    const auto distance = [&](int corner) { return glm::abs(corners[corner] - space.centre); };
    largest = glm::max(distance(0), glm::max(distance(1), distance(2)));
  }
  return glm::dot(products, extent) > 8.0 * glm::dot(n, largest);
}

}  // namespace

Bounds boundsOf(const Scene& scene) {
  Bounds box{dvec3(kInfinity), dvec3(-kInfinity)};
  const auto add = [&](const dvec3& lo, const dvec3& hi) {
    box.lo = glm::min(box.lo, lo);
    box.hi = glm::max(box.hi, hi);
  };
  for (const Mesh& mesh : scene.meshes) {
    if (mesh.sphere)
      add(mesh.sphere->centre - mesh.sphere->radius, mesh.sphere->centre + mesh.sphere->radius);
    for (const glm::uvec3& t : mesh.triangles)
      for (int corner = 0; corner < 3; ++corner)
        add(mesh.positions[t[corner]], mesh.positions[t[corner]]);
  }
  return box;
}

double diagonalOf(const Bounds& bounds) {
  return bounds.lo.x > bounds.hi.x ? 0.0 : glm::length(bounds.hi - bounds.lo);
}

bool isCap(const Sphere& sphere, const Normalisation& space) {
  if (!space.wide()) return false;
  const double distance = glm::length(sphere.centre - space.centre);
  const double nearest = std::abs(distance - sphere.radius);
  return distance + sphere.radius > kOrdinaryReach * std::max(nearest, space.unit);
}

bool hasCaps(const Scene& scene, const Normalisation& space) {
  return std::ranges::any_of(
      scene.meshes, [&](const Mesh& mesh) { return mesh.sphere && isCap(*mesh.sphere, space); });
}

bool hasSlivers(const Scene& scene, const Normalisation& space) {
  return std::ranges::any_of(scene.meshes, [&](const Mesh& mesh) {
    const auto& p = mesh.positions;
    return std::ranges::any_of(mesh.triangles, [&](const glm::uvec3& t) {
      return isSliver({p[t.x], p[t.y], p[t.z]}, space);
    });
  });
}

Normalisation normalisationOf(const Scene& scene) {
  const Bounds box = boundsOf(scene);
  if (box.lo.x > box.hi.x) return {};
  const Visible visible(scene);
  if (!visible.usable()) return ordinary(box);
  if (visible.pixel() < kNarrowPixel) return narrow(visible, box);
  const double reach = glm::length(halfOf(box)) + glm::length(visible.eye() - centreOf(box));
  const double near = visible.range(reach / kOrdinaryReach).near;
  if (!(near < reach / kOrdinaryReach)) return ordinary(box);
  const Normalisation space = around(visible.eye(), near, box);
  refuseBeyond(6.0 * kPieceReach * e * std::max(1.0, space.unit / near) / visible.pixel(), near,
               farthestFrom(visible.eye(), box));
  return space;
}

}  // namespace laver
