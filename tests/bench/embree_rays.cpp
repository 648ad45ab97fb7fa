#include "bench/embree_rays.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

#include "bench/embree_packet.h"

namespace laver::bench {
namespace {

/// Seconds that `threads` threads take to call part(i) for all i below count.
template <class Part>
double inThreads(std::size_t count, unsigned threads, const Part& part) {
  constexpr std::size_t kGrain = 64;
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    const FlushDenormals flush;
    for (std::size_t i = next.fetch_add(kGrain); i < count; i = next.fetch_add(kGrain))
      part(i, std::min(count, i + kGrain));
  };
  const auto start = std::chrono::steady_clock::now();
  std::vector<std::thread> others;
  for (unsigned t = 1; t < threads; ++t) others.emplace_back(work);
  work();
  for (std::thread& other : others) other.join();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

EmbreeRays::EmbreeRays(std::span<const test::TestRay> rays, std::span<const glm::vec3> points)
    : rayCount_(rays.size()),
      pointCount_(points.size()),
      rays_((rays.size() + 15) / 16),
      hits_(rays_.size()),
      points_((points.size() + 15) / 16),
      seen_(points_.size()) {
  for (std::size_t i = 0; i < rays_.size() * 16; ++i) {
    // Rays that fill up the last packet end before they start.
    const test::TestRay ray =
        i < rays.size() ? rays[i] : test::TestRay{glm::vec3(0.0F), 0.0F, glm::vec3(1.0F), -1.0F};
    Rays16& to = rays_[i / 16];
    for (int axis = 0; axis < 3; ++axis) {
      to.org[axis][i % 16] = ray.origin[axis];
      to.dir[axis][i % 16] = ray.direction[axis];
    }
    to.tmin[i % 16] = ray.tmin;
    to.tmax[i % 16] = ray.tmax;
  }
  for (std::size_t i = 0; i < points_.size() * 16; ++i)
    for (int axis = 0; axis < 3; ++axis)
      points_[i / 16].p[axis][i % 16] =
          i < points.size() ? points[i][axis] : std::numeric_limits<float>::quiet_NaN();
}

double EmbreeRays::closest(RTCScene scene, int width, bool coherent, unsigned threads) {
  return inThreads(rays_.size(), threads, [&](std::size_t begin, std::size_t end) {
    alignas(64) int all[16];
    std::fill_n(all, 16, -1);
    RTCRayHit16 packet{};
    std::memset(packet.ray.mask, -1, sizeof packet.ray.mask);
    RTCIntersectContext context = contextOf(coherent);
    for (std::size_t i = begin; i < end; ++i) {
      const Rays16& from = rays_[i];
      const auto copy = [](auto& out, const auto& in) { std::memcpy(out, in, sizeof out); };
      copy(packet.ray.org_x, from.org[0]), copy(packet.ray.dir_x, from.dir[0]);
      copy(packet.ray.org_y, from.org[1]), copy(packet.ray.dir_y, from.dir[1]);
      copy(packet.ray.org_z, from.org[2]), copy(packet.ray.dir_z, from.dir[2]);
      copy(packet.ray.tnear, from.tmin), copy(packet.ray.tfar, from.tmax);
      std::memset(packet.hit.geomID, -1, sizeof packet.hit.geomID);
      std::memset(packet.hit.instID, -1, sizeof packet.hit.instID);
      std::memset(packet.hit.primID, -1, sizeof packet.hit.primID);
      intersect(scene, width, context, all, packet);
      Hits16& to = hits_[i];
      copy(to.t, packet.ray.tfar), copy(to.u, packet.hit.u), copy(to.v, packet.hit.v);
      for (int k = 0; k < 16; ++k)
        to.id[k] =
            packet.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID ? shared::NO_HIT : packet.hit.primID[k];
    }
  });
}

double EmbreeRays::visible(RTCScene scene, int width, glm::vec3 light, unsigned threads) {
  return inThreads(points_.size(), threads, [&](std::size_t begin, std::size_t end) {
    RTCRay16 packet{};
    std::memset(packet.mask, -1, sizeof packet.mask);
    alignas(64) int valid[16];
    RTCIntersectContext context = contextOf(true);
    for (std::size_t i = begin; i < end; ++i) {
      const Points16& from = points_[i];
      int any = 0;
      for (int k = 0; k < 16; ++k) {
        const float x = from.p[0][k], y = from.p[1][k], z = from.p[2][k];
        valid[k] = x == x ? -1 : 0;
        any |= valid[k];
        packet.org_x[k] = x, packet.org_y[k] = y, packet.org_z[k] = z;
        packet.dir_x[k] = light.x - x, packet.dir_y[k] = light.y - y;
        packet.dir_z[k] = light.z - z;
        packet.tfar[k] = valid[k] != 0 ? 1.0F : -1.0F;
      }
      if (any != 0) occluded(scene, width, context, valid, packet);
      for (int k = 0; k < 16; ++k)
        seen_[i].seen[k] = valid[k] != 0 && packet.tfar[k] >= 0.0F ? 1 : 0;
    }
  });
}

std::vector<test::TestHit> EmbreeRays::hits() const {
  std::vector<test::TestHit> out(rayCount_);
  for (std::size_t i = 0; i < rayCount_; ++i) {
    const Hits16& from = hits_[i / 16];
    out[i] = {from.t[i % 16], from.u[i % 16], from.v[i % 16], from.id[i % 16]};
  }
  return out;
}

std::vector<std::uint32_t> EmbreeRays::seen() const {
  std::vector<std::uint32_t> out(pointCount_);
  for (std::size_t i = 0; i < pointCount_; ++i) out[i] = seen_[i / 16].seen[i % 16];
  return out;
}

}  // namespace laver::bench
