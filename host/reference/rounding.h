#pragma once
#include <glm/glm.hpp>

#include "reference/camera.h"
#include "render/space.h"
#include "scene/scene.h"

namespace laver {

/// Unit roundoff of float, half an ulp of 1; derivations call it e.
inline constexpr double kUnitRoundoff = 0x1p-24;

/// How far float arithmetic may move the hit of a kernel's sample, computed from a scene's numbers
/// alone: the one bound that all comparisons with the reference use. It holds to first order in
/// e = 2^-24 on every device that Vulkan allows: sums and products round to nearest, quotients are
/// within 2.5 ulp = 5 e, and fma() may round twice.
///
/// Vertices v are relative to the centre of device coordinates (render/space.h). o is the origin of
/// a ray, and d the distance of the hit from the camera. R >= |o| + |v| bounds the geometry near
/// the hit: in an ordinary space, where |v| <= sqrt(3), it is |o| + sqrt(3); in a wide one at most
/// |o| + 12 times the hit's distance from the centre (at least Normalisation::unit), as pieces are
/// no larger.
///
/// 1. The camera ray rotates. D = x X + y Y + Z is rounded in its columns, in x and y, in products
///    and in sums: e (3 |x X| + 3 |y Y| + |Z| + |x X + y Y| + |D|), at most 6.4 e |D| if X, Y and
///    Z are orthogonal. The slopes of the shear are quotients: an error of 5 e r of a slope r
///    rotates the ray by 5 e r / (1 + r^2) <= 2.5 e. Rays of a far camera start on a plane:
///    distances are measured from there, and the start, which is computed in the same way, is off
///    by 8 e of the largest distance of a start from the centre.
/// 2. The triangle test moves edges sideways (triangle.h). It rounds the origin, e |o|; a corner,
///    e |v|; their difference p, e |p|; product and difference of the shear, 3 e |p|; and the
///    edge functions where products are not fused, e |p|: in all e (R + 5 F), where F <= R is the
///    distance from o to the farthest corner. For a sphere of radius r its centre takes the
///    corner's place, and the outline moves by 6 e r more (sphere.h); with F = |p| + r the same
///    bound holds. A sphere that is given by its nearest point q (cap.h) errs by 4 e (|o - q| + d):
///    F is their sum.
/// 3. The hit point moves along its surface (point.h). Weights are off by 3 e of the edge
///    functions, 2 e of their sum and 5 e of the quotient, and edges, products and sums by 3 e:
///    13 e of an edge, which is shorter than 2 R. The position and the offset origin of a shadow
///    ray round by e |v| each, and lie up to 8 e |v| apart: in all 36 e R. For a sphere it
///    is 10 e r and 39 e, which is less.
/// 4. The shadow ray errs as the camera ray does, between points less than 2 R apart: 4 e R by
///    rounding the light's position, which shifts the ray at the blocker, 7 e R by direction and
///    slopes (3.5 e of the distance), 11 e R by the blocker's edges. In a wide space R is that of
///    the hit or of the blocker, whichever reaches farther.
///
/// So a camera ray is off by an angle of at most e (rotation + 6 R / d), with the sum of part 1
/// as e rotation, and a hit is lit like a point within an angle of e (rotation + 64 R / d) of it.
/// Shadows of a blocker near the light, or on a surface that the light grazes, may move farther
/// than the sum of 3 and 4: that is not bounded, but edges are in practice much shorter than 2 R.
class Rounding {
 public:
  explicit Rounding(const Scene& scene);

  /// Pixels by which a camera ray may miss its film position, at a distance from the camera in
  /// scene units.
  double ofHit(glm::dvec2 film, double distance) const;
  /// The same for shading at the hit: textures, and shadows of blockers within `blocker` scene
  /// units.
  double ofShading(glm::dvec2 film, double distance, double blocker = 0.0) const;
  /// Distance of blockers, in scene units, beyond which ofShading() is constant; 0: it always is.
  double farthestBlocker() const { return space_.wide() ? 2.0 * reach_ : 0.0; }
  /// The same for a background, looked up by two angles of the direction: 7 e for the rotation of
  /// the direction, and for each angle 25 e (texture/angle.glsl) and 12 e (its position in the
  /// image).
  double ofBackground(glm::dvec2 film) const;

  /// Scene units by which a camera ray may miss a point at `distance` from the camera, on a
  /// primitive whose farthest point is `farthest` from the origins of rays, and `corner` from the
  /// centre.
  double sideways(glm::dvec2 film, double distance, double farthest, double corner) const;
  /// Bound of the distance between the origins of camera rays and the centre.
  double originReach() const { return origin_; }
  const Normalisation& space() const { return space_; }

  /// Angle by which a direction that is sampled around a shading normal may rotate: the normal's
  /// own error at triangles that are not slivers (tests/stability measures it), and the arithmetic
  /// of direction.h. The random numbers of the direction move by no more.
  static constexpr double kDirection = 25.0 * kUnitRoundoff;

 private:
  double rotationOf(glm::dvec2 film) const;
  double startError() const { return start_ > 0.0 ? kStart * origin_ : 0.0; }
  double reachAt(double distance) const;

  static constexpr double kStart = 8.0;
  double pixelsPerRadian(glm::dvec2 film) const;

  Camera camera_;
  reference::View view_;
  Normalisation space_;
  // In scene units: distance from the camera to the plane where rays start; max |o|; R of the
  // scene.
  double start_, origin_, reach_;
};

/// How far the triangle test may move a corner sideways (part 2 above), for a given float ray and
/// float corner: `p` is the corner relative to the origin, `sheared` its position across the ray.
/// It is the sum of the roundings of p.x, p.z (z: the largest axis of d), slope (5 e), product and
/// difference.
double cornerShift(const glm::dvec3& p, const glm::dvec3& direction, glm::dvec2 sheared);

/// How far the triangle test may move an edge between two such positions: a difference of products
/// that are not fused has the sign of the rounded products.
double edgeShift(glm::dvec2 a, glm::dvec2 b);

}  // namespace laver
