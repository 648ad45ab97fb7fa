#pragma once
#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <cstring>

namespace laver::bench {

/// Treats denormals as zero in this thread until the end of the scope, as Embree's manual
/// recommends.
class FlushDenormals {
 public:
  FlushDenormals() {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() { _mm_setcsr(before_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
};

inline RTCIntersectContext contextOf(bool coherent) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

inline RTCRay rayOf(const RTCRay16& from, int i) {
  RTCRay ray;
  ray.org_x = from.org_x[i], ray.org_y = from.org_y[i], ray.org_z = from.org_z[i];
  ray.dir_x = from.dir_x[i], ray.dir_y = from.dir_y[i], ray.dir_z = from.dir_z[i];
  ray.tnear = from.tnear[i], ray.tfar = from.tfar[i];
  ray.time = 0.0F, ray.mask = ~0U, ray.id = 0, ray.flags = 0;
  return ray;
}

inline RTCRay8 halfOf(const RTCRay16& from, int first) {
  RTCRay8 to;
  const auto copy = [&](auto& out, const auto& in) { std::memcpy(out, in + first, sizeof out); };
  copy(to.org_x, from.org_x), copy(to.org_y, from.org_y), copy(to.org_z, from.org_z);
  copy(to.dir_x, from.dir_x), copy(to.dir_y, from.dir_y), copy(to.dir_z, from.dir_z);
  copy(to.tnear, from.tnear), copy(to.tfar, from.tfar), copy(to.time, from.time);
  copy(to.mask, from.mask), copy(to.id, from.id), copy(to.flags, from.flags);
  return to;
}

/// Nearest hits of those of 16 rays whose `valid` is -1, with `width` rays per call.
inline void intersect(RTCScene scene, int width, RTCIntersectContext& context, const int* valid,
                      RTCRayHit16& rays) {
  if (width == 16) rtcIntersect16(valid, scene, &context, &rays);
  for (int i = 0; width == 8 && i < 16; i += 8) {
    RTCRayHit8 half;
    half.ray = halfOf(rays.ray, i);
    std::memset(half.hit.geomID, -1, sizeof half.hit.geomID);
    std::memset(half.hit.instID, -1, sizeof half.hit.instID);
    rtcIntersect8(valid + i, scene, &context, &half);
    const auto copy = [&](auto& out, const auto& in) { std::memcpy(out + i, in, sizeof in); };
    copy(rays.ray.tfar, half.ray.tfar), copy(rays.hit.u, half.hit.u), copy(rays.hit.v, half.hit.v);
    copy(rays.hit.Ng_x, half.hit.Ng_x), copy(rays.hit.Ng_y, half.hit.Ng_y);
    copy(rays.hit.Ng_z, half.hit.Ng_z), copy(rays.hit.primID, half.hit.primID);
    copy(rays.hit.geomID, half.hit.geomID);
  }
  for (int i = 0; width == 1 && i < 16; ++i) {
    if (valid[i] == 0) continue;
    RTCRayHit one;
    one.ray = rayOf(rays.ray, i);
    one.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    one.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &one);
    rays.ray.tfar[i] = one.ray.tfar;
    rays.hit.u[i] = one.hit.u, rays.hit.v[i] = one.hit.v;
    rays.hit.Ng_x[i] = one.hit.Ng_x, rays.hit.Ng_y[i] = one.hit.Ng_y;
    rays.hit.Ng_z[i] = one.hit.Ng_z;
    rays.hit.primID[i] = one.hit.primID, rays.hit.geomID[i] = one.hit.geomID;
  }
}

/// Sets tfar to a negative value for occluded rays.
inline void occluded(RTCScene scene, int width, RTCIntersectContext& context, const int* valid,
                     RTCRay16& rays) {
  if (width == 16) rtcOccluded16(valid, scene, &context, &rays);
  for (int i = 0; width == 8 && i < 16; i += 8) {
    RTCRay8 half = halfOf(rays, i);
    rtcOccluded8(valid + i, scene, &context, &half);
    std::memcpy(rays.tfar + i, half.tfar, sizeof half.tfar);
  }
  for (int i = 0; width == 1 && i < 16; ++i) {
    if (valid[i] == 0) continue;
    RTCRay one = rayOf(rays, i);
    rtcOccluded1(scene, &context, &one);
    rays.tfar[i] = one.tfar;
  }
}

}  // namespace laver::bench
