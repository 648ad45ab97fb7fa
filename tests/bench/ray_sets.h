#pragma once
#include <span>
#include <vector>

#include "render/packed.h"
#include "trace/ray_tracer.h"

namespace laver::bench {

using test::TestHit;
using test::TestRay;

/// One ray through each pixel, in tiles of 8 x 8 pixels, within them of 4 x 4, within those of 4 x
/// 2, so that packets of 64, 16 and 8 rays are all compact. Rows of tiles are permuted as in laver.
std::vector<TestRay> cameraRays(const Packed& data);

/// The same rays in random order, so that neighbours are incoherent.
std::vector<TestRay> shuffled(std::vector<TestRay> rays);

/// Hit points, offset from the surface, where it faces the light; else NaN.
std::vector<glm::vec3> litPoints(const Packed& data, std::span<const TestRay> rays,
                                 std::span<const TestHit> hits);

/// From each hit, a ray in a cosine-distributed direction, as a diffuse surface scatters.
std::vector<TestRay> bounced(const Packed& data, std::span<const TestRay> rays,
                             std::span<const TestHit> hits);

}  // namespace laver::bench
