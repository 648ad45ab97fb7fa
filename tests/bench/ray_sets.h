#pragma once
#include <span>
#include <vector>

#include "render/packed.h"
#include "trace/ray_tracer.h"

namespace laver::bench {

using test::TestHit;
using test::TestRay;

/// One ray through each pixel, 8 x 8 pixels after the other, in them 4 x 4, in those 4 x 2: packets
/// of 64, 16 and 8 rays are all compact. Rows of tiles are permuted as laver permutes them.
std::vector<TestRay> cameraRays(const Packed& data);

/// The same rays in an order that no two neighbours share anything.
std::vector<TestRay> shuffled(std::vector<TestRay> rays);

/// Where rays ended, moved off the surface, if it faces the light; else NaN.
std::vector<glm::vec3> litPoints(const Packed& data, std::span<const TestRay> rays,
                                 std::span<const TestHit> hits);

/// From each hit a ray in a random direction, likelier along the normal as a matt surface sends it.
std::vector<TestRay> bounced(const Packed& data, std::span<const TestRay> rays,
                             std::span<const TestHit> hits);

}  // namespace laver::bench
