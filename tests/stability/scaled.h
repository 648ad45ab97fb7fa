#pragma once
#include "image/image.h"
#include "scene/scene.h"

namespace laver::test {

/// The scene with vertices, camera, clip planes and lights scaled; lights are brighter by the
/// square, so that what arrives is the same.
Scene scaled(Scene scene, double factor);

/// Undoes what a scale does to a picture: that of depth is 1 / distance.
void undoScale(const Scene& scene, double factor, Image& image);

/// Triangles that Nori drops at that scale, whatever the ray of unit direction: |det| is at most
/// twice the area.
std::uint64_t naiveLost(const Scene& scene, double factor);

}  // namespace laver::test
