#pragma once
#include <cmath>
#include <glm/glm.hpp>

namespace laver::reference {

/// The ray origin + t * direction; the direction has any length except 0.
struct Ray {
  glm::dvec3 origin;
  glm::dvec3 direction;
};

/// Maps points to a space where the ray starts at 0 and runs along z (Woop, Benthin, Wald,
/// "Watertight Ray/Triangle Intersection", 2013, section 3.1). The result depends on the ray and
/// the point only, not on the triangle. Each rounding of x and y is at most 2^-53 of the largest
/// |point - origin|, and there are fewer than six.
class Shear {
 public:
  explicit Shear(const Ray& ray) : origin_(ray.origin) {
    const glm::dvec3 size = glm::abs(ray.direction);
    z_ = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    x_ = (z_ + 1) % 3;
    y_ = (z_ + 2) % 3;
    depth_ = ray.direction[z_];
    slope_ = glm::dvec2(ray.direction[x_], ray.direction[y_]) / depth_;
  }

  /// x and y: offset from the ray at the point's own depth; z: depth along the dominant axis, with
  /// its sign.
  glm::dvec3 operator()(const glm::dvec3& point) const {
    const double z = point[z_] - origin_[z_];
    return {point[x_] - origin_[x_] - slope_.x * z, point[y_] - origin_[y_] - slope_.y * z, z};
  }

  /// The largest component of the ray's direction: t = z / depth() for a mapped point.
  double depth() const { return depth_; }

 private:
  glm::dvec3 origin_;
  int x_, y_, z_;
  double depth_;
  glm::dvec2 slope_;
};

}  // namespace laver::reference
