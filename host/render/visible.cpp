#include "render/visible.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>

#include "core/parallel.h"

namespace laver {
namespace {

using glm::dvec3;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

void widen(DepthRange& range, double depth) {
  range.near = std::min(range.near, depth);
  range.far = std::max(range.far, depth);
}

/// A triangle after up to five cuts.
struct Polygon {
  std::array<dvec3, 8> corner;
  std::size_t count = 0;
  void add(dvec3 p) { corner[count++] = p; }
};

/// What of a convex polygon is where distance() >= 0, which is linear (Sutherland and Hodgman,
/// "Reentrant Polygon Clipping", 1974).
template <class Distance>
Polygon cut(const Polygon& polygon, const Distance& distance) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const dvec3 p = polygon.corner[i], q = polygon.corner[(i + 1) % polygon.count];
    const double a = distance(p), b = distance(q);
    if (a >= 0.0) result.add(p);
    if ((a >= 0.0) != (b >= 0.0)) result.add(p + (q - p) * (a / (a - b)));
  }
  return result;
}

}  // namespace

struct Visible::Corners {
  dvec3 a, b, c;  // in camera space
};

Visible::Visible(const Scene& scene)
    : scene_(scene),
      eye_(dvec3(scene.camera.toWorld[3]) / scene.camera.toWorld[3].w),
      nearClip_(scene.camera.nearClip) {
  const Camera& camera = scene.camera;
  const glm::dmat3 m(camera.toWorld);
  axisLength_ = glm::length(m[2]);
  axis_ = m[2] / axisLength_;
  toCamera_ = glm::inverse(m);
  const double slope = std::tan(camera.fov * std::numbers::pi / 360.0);
  slopes_ = glm::dvec2(slope, slope * camera.height / camera.width);
  const double wide = std::max(glm::length(m[0]), glm::length(m[1]));
  if (camera.row->lens) {
    // As reference/camera.cpp divides by w.
    const double w = std::abs(camera.toWorld[3].w);
    lens_ = camera.lensRadius / w;
    lensWidth_ = lens_ * wide;
    slopes_ += camera.lensRadius / camera.focalDistance;
  }
  const double thin = std::min(glm::length(m[0]), glm::length(m[1]));
  halfWidth_ = std::max(slopes_.x, slopes_.y) * wide / axisLength_;
  pixel_ = 2.0 * slope * camera.subpixels / camera.width * thin / axisLength_;
  const dvec3 sizes = glm::abs(toCamera_[0]) + glm::abs(toCamera_[1]) + glm::abs(toCamera_[2]);
  usable_ = std::isfinite(sizes.x + sizes.y + sizes.z) && std::isfinite(halfWidth_) &&
            pixel_ > 0.0 && std::isfinite(eye_.x + eye_.y + eye_.z);
}

void Visible::addTriangle(const Corners& t, DepthRange& range) const {
  const auto beyond = [&](const auto& distance) {
    return distance(t.a) < 0.0 && distance(t.b) < 0.0 && distance(t.c) < 0.0;
  };
  const auto left = [&](const dvec3& p) { return slopes_.x * p.z + lens_ - p.x; };
  const auto right = [&](const dvec3& p) { return slopes_.x * p.z + lens_ + p.x; };
  const auto above = [&](const dvec3& p) { return slopes_.y * p.z + lens_ - p.y; };
  const auto below = [&](const dvec3& p) { return slopes_.y * p.z + lens_ + p.y; };
  const auto ahead = [&](const dvec3& p) { return p.z - nearClip_; };
  if (beyond(ahead) || beyond(left) || beyond(right) || beyond(above) || beyond(below)) return;
  Polygon polygon;
  for (const dvec3& p : {t.a, t.b, t.c}) polygon.add(p);
  polygon = cut(cut(cut(cut(cut(polygon, ahead), left), right), above), below);
  for (std::size_t i = 0; i < polygon.count; ++i) widen(range, polygon.corner[i].z * axisLength_);
}

/// A ray from a point of the lens sees a sphere as the ray from its centre sees a sphere that has
/// moved as far.
void Visible::addSphere(const Sphere& sphere, DepthRange& range) const {
  if (lensWidth_ == 0.0) return addSphereOfPinhole(sphere, range);
  for (const double radius : {sphere.radius + lensWidth_, sphere.radius - lensWidth_})
    if (radius > 0.0) addSphereOfPinhole({sphere.centre, radius}, range);
  if (std::abs(glm::length(sphere.centre - eye_) - sphere.radius) <= lensWidth_)
    widen(range, nearClip_ * axisLength_);
}

/// Along the ray of the view's cone that comes nearest to the centre or, from inside, stays
/// farthest from it.
void Visible::addSphereOfPinhole(const Sphere& sphere, DepthRange& range) const {
  const dvec3 toCentre = sphere.centre - eye_;
  const double distance = glm::length(toCentre), r = sphere.radius;
  const double cone = std::atan(std::hypot(halfWidth_, halfWidth_));
  const double angle =
      distance > 0.0 ? std::acos(std::clamp(glm::dot(toCentre, axis_) / distance, -1.0, 1.0)) : 0.0;
  const bool inside = distance < r;
  const double least = std::max(angle - cone, 0.0);
  const double most = std::min(angle + cone, std::numbers::pi);
  const double tangent = inside ? std::numbers::pi : std::asin(r / distance);
  if (!inside && least >= tangent) return;
  // The point of the sphere at that angle from the centre's direction: (d - r)(d + r) is exact
  // where the eye is near.
  const auto at = [&](double theta) {
    const double along = distance * std::cos(theta);
    const double power = (distance - r) * (distance + r);
    const double root = std::sqrt(std::max(along * along - power, 0.0));
    return inside ? along + root : power / (along + root);
  };
  const double first = at(inside ? most : least),
               last = at(inside ? least : std::min(most, tangent));
  if (!(last >= nearClip_ * axisLength_)) return;
  widen(range, std::max(first * std::cos(cone), nearClip_ * axisLength_));
  widen(range, last);
}

DepthRange Visible::rangeOf(const Mesh& mesh, double limit) const {
  DepthRange range{kInfinity, -kInfinity};
  if (mesh.sphere) {
    addSphere(*mesh.sphere, range);
    return range;
  }
  std::mutex adding;
  parallelFor(mesh.triangles.size(), 1U << 14, 0, [&](std::size_t begin, std::size_t end) {
    DepthRange part{kInfinity, -kInfinity};
    for (std::size_t i = begin; i < end; ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      const dvec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
      const dvec3 lo = glm::min(glm::min(a, b), c) - eye_, hi = eye_ - glm::max(glm::max(a, b), c);
      if (std::max({lo.x, lo.y, lo.z, hi.x, hi.y, hi.z}) >= limit) continue;
      addTriangle({toCamera(a), toCamera(b), toCamera(c)}, part);
    }
    const std::scoped_lock lock(adding);
    if (part.near <= part.far) {
      widen(range, part.near);
      widen(range, part.far);
    }
  });
  return range;
}

DepthRange Visible::range(double limit) const {
  DepthRange all{kInfinity, -kInfinity};
  for (const Mesh& mesh : scene_.meshes) {
    const DepthRange range = rangeOf(mesh, limit);
    if (range.near > range.far) continue;
    widen(all, range.near);
    widen(all, range.far);
  }
  return all;
}

}  // namespace laver
