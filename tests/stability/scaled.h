#pragma once
#include "image/image.h"
#include "scene/scene.h"

namespace laver::test {

/// The scene with vertices, camera, clip planes and lights scaled. Lights are brighter by the
/// square, so that the irradiance is unchanged.
Scene scaled(Scene scene, double factor);

/// Undoes the effect of the scale on a picture: depth is 1 / distance.
void undoScale(const Scene& scene, double factor, Image& image);

/// Number of triangles that Nori misses at that scale for any ray of unit direction, since |det| is
/// at most twice the area.
std::uint64_t naiveLost(const Scene& scene, double factor);

}  // namespace laver::test
