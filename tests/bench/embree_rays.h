#pragma once
#include <embree3/rtcore.h>

#include <span>
#include <vector>

#include "trace/ray_tracer.h"

namespace laver::bench {

/// Traces rays from memory with Embree. Rays and points are in blocks of 16, structure of arrays,
/// as Embree's packets need them.
class EmbreeRays {
 public:
  EmbreeRays(std::span<const test::TestRay> rays, std::span<const glm::vec3> points);

  /// Seconds for all rays, with `width` rays per call.
  double closest(RTCScene scene, int width, bool coherent, unsigned threads);
  /// Seconds for the segments from all points that are not NaN to the light.
  double visible(RTCScene scene, int width, glm::vec3 light, unsigned threads);

  /// Results of the latest calls, as RayTracer returns them; u and v refer to the corners of the
  /// mesh.
  std::vector<test::TestHit> hits() const;
  std::vector<std::uint32_t> seen() const;

 private:
  struct alignas(64) Rays16 {
    float org[3][16], dir[3][16], tmin[16], tmax[16];
  };
  struct alignas(64) Hits16 {
    float t[16], u[16], v[16];
    std::uint32_t id[16];
  };
  struct alignas(64) Points16 {
    float p[3][16];
  };
  struct alignas(64) Seen16 {
    std::uint32_t seen[16];
  };
  std::size_t rayCount_, pointCount_;
  std::vector<Rays16> rays_;
  std::vector<Hits16> hits_;
  std::vector<Points16> points_;
  std::vector<Seen16> seen_;
};

}  // namespace laver::bench
