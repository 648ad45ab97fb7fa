#pragma once
#include <glm/glm.hpp>

#include "reference/camera.h"
#include "scene/scene.h"

namespace laver {

/// Unit roundoff of float, half an ulp of 1; derivations call it e.
inline constexpr double kUnitRoundoff = 0x1p-24;

/// How far float arithmetic may move the hit of a kernel's sample, computed from a scene's numbers
/// alone: the one bound that all comparisons with the reference use. It holds to first order in
/// e = 2^-24 on every device that Vulkan allows: sums and products round to nearest, quotients are
/// within 2.5 ulp = 5 e, and fma() may round twice.
///
/// Lengths are those of normalised space, where vertices v lie in [-1, 1]^3, so that |v| <=
/// sqrt(3). o is the camera, R = |o| + sqrt(3) >= |v - o|, and d <= R the distance of the hit.
///
/// 1. The camera ray rotates. D = x X + y Y + Z is rounded in its columns, in x and y, in products
///    and in sums: e (3 |x X| + 3 |y Y| + |Z| + |x X + y Y| + |D|), at most 6.4 e |D| if X, Y and
///    Z are orthogonal. The slopes of the shear are quotients: an error of 5 e r of a slope r
///    rotates the ray by 5 e r / (1 + r^2) <= 2.5 e.
/// 2. The triangle test moves edges sideways (triangle.h). It rounds the origin, e |o|; a corner,
///    e sqrt(3); their difference p, e |p|; product and difference of the shear, 3 e |p|; and the
///    edge functions where products are not fused, e |p|: in all e (R + 5 F), where F <= R is the
///    distance of the farthest corner. For a sphere of radius r its centre takes the corner's
///    place, and the outline moves by 6 e r more (sphere.h): with F = |p| + r no farther.
/// 3. The hit point moves along its surface (point.h). Weights are off by 3 e of the edge
///    functions, 2 e of their sum and 5 e of the quotient, and edges, products and sums by 3 e:
///    13 e of an edge, which is shorter than 2 R. The position and the offset origin of a shadow
///    ray round by e sqrt(3) each, and lie up to 8 e sqrt(3) apart: in all 36 e R. For a sphere it
///    is 10 e r and 39 e, which is less.
/// 4. The shadow ray errs as the camera ray does, between points less than 2 R apart: 4 e R by the
///    light's rounding, as it moves the ray at the blocker, 7 e R by direction and slopes (3.5 e
///    of the distance), 11 e R by the blocker's edges.
///
/// So a camera ray is off by an angle of at most e (rotation + 6 R / d), and a hit is lit like a
/// point within an angle of e (rotation + 64 R / d) of it. Shadows of a blocker near the light,
/// or on a surface that the light grazes, may move farther than the sum of 3 and 4; edges that are
/// shorter than the scene leave room for that.
class Rounding {
 public:
  explicit Rounding(const Scene& scene);

  /// Pixels by which a camera ray may miss its film position, at a distance from the camera in
  /// scene units.
  double ofHit(glm::dvec2 film, double distance) const;
  /// The same for the shading of the hit: occlusion of lights, textures.
  double ofShading(glm::dvec2 film, double distance) const;
  /// The same for a background, looked up by two angles of the direction: 7 e for the rotation of
  /// the direction, and for each angle 25 e (texture/angle.glsl) and 12 e (its position in the
  /// image).
  double ofBackground(glm::dvec2 film) const;

  /// Scene units by which a camera ray may miss a point at `distance` from the camera, on a
  /// primitive whose farthest point is at `farthest`.
  double sideways(glm::dvec2 film, double distance, double farthest) const;

  /// Angle by which a direction that is sampled around a shading normal may rotate: the normal's
  /// own error at triangles that are not slivers (tests/stability measures it), and the arithmetic
  /// of direction.h. The random numbers of the direction move by no more.
  static constexpr double kDirection = 25.0 * kUnitRoundoff;

 private:
  double rotationOf(glm::dvec2 film) const;
  double pixelsPerRadian(glm::dvec2 film) const;

  Camera camera_;
  reference::View view_;
  double reach_;  // R, in scene units
};

/// How far the triangle test may move a corner sideways (part 2 above), for a given float ray and
/// float corner: `p` is the corner relative to the origin, `sheared` its position across the ray.
/// With z the largest axis of the direction d: differences p.x and p.z, slope (5 e), product, last
/// difference.
double cornerShift(const glm::dvec3& p, const glm::dvec3& direction, glm::dvec2 sheared);

/// How far the triangle test may move an edge between two such positions: a difference of products
/// that are not fused has the sign of the rounded products.
double edgeShift(glm::dvec2 a, glm::dvec2 b);

}  // namespace laver
