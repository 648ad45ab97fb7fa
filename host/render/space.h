#pragma once
#include <glm/glm.hpp>

#include "scene/scene.h"

namespace laver {

/// Device coordinates: p' = scale * (p - centre). The scale is a power of two, so that it rounds
/// nothing.
///
/// Rounding is to be small as seen: an error is a share of the distance from the centre, and has to
/// be small beside the distance from the camera. Ordinary scenes are centred on the box of all
/// meshes, whose vertices come to lie in [-1, 1]^3. Where something visible is nearer than 1/16 of
/// what that box reaches, the centre is the camera, and `unit` says how near: triangles are then
/// split on the host so that none is much larger than its distance from the centre
/// (render/split_meshes.h), and spheres of which only a small part is near are given by their
/// nearest point (shared/cap.h).
///
/// A float direction is off by some e = 2^-24 of the distance. Where pixels are so narrow that this
/// shows, rays start on a plane just before what is visible. Their starts are linear in the film
/// position, as directions are, so that the host makes the constants in double precision.
struct Normalisation {
  glm::dvec3 centre{0.0};
  double scale = 1.0;
  double reach = 4.0;  ///< device units; no two points of the meshes are farther apart
  /// Scene units; 0: no triangle is split. Visible things nearer to the centre than this are held
  /// as if they were this far away.
  double unit = 0.0;
  double start = 0.0;  ///< of the plane where rays start: z of camera space

  bool wide() const { return unit > 0.0; }
  glm::dvec3 apply(glm::dvec3 p) const { return (p - centre) * scale; }
};

/// A box of all primitives in the scene's space; lo.x > hi.x where there are none.
struct Bounds {
  glm::dvec3 lo, hi;
};
Bounds boundsOf(const Scene& scene);
/// 0 where there are none.
double diagonalOf(const Bounds& bounds);

/// Throws Error(Device) where floats cannot hold what the camera sees to half a pixel.
Normalisation normalisationOf(const Scene& scene);

/// Whether a sphere is so large beside its distance from the centre that it is given by its nearest
/// point.
bool isCap(const Sphere& sphere, const Normalisation& space);
bool hasCaps(const Scene& scene, const Normalisation& space);

/// Whether some triangle is so narrow that a float cross product of its edges tilts its plane by
/// more than the offset of rays that start on it covers.
bool hasSlivers(const Scene& scene, const Normalisation& space);

/// Largest max-norm distance from the centre of what `unit` stands for, in units: one split
/// triangle reaches no farther (derived in render/split_meshes.h).
inline constexpr double kPieceReach = 12.0;

/// Ratio of reach and distance up to which a part of a scene is ordinary.
inline constexpr double kOrdinaryReach = 16.0;

}  // namespace laver
