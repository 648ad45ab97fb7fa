// The main function of a trace kernel: traces camera rays and stores radiance and film position of each
// sample. The integrator defines integrate(), which adds the radiance along each ray to `radiance`; in scenes
// with many lights it is called once for every few of them.
#include "trace/camera_rays.glsl"
#include "trace/queries.glsl"

bool finiteAndNotNegative(float x) {
  const uint bits = floatBitsToUint(x);
  return bits < 0x7f800000u || bits == 0x80000000u;
}

bool usable(vec3 v) {
  const vec3 u = SIGNED ? abs(v) : v;
  return finiteAndNotNegative(u.r) && finiteAndNotNegative(u.g) && finiteAndNotNegative(u.b);
}

void main() {
  const uvec3 tile = tileOrigin();
  Rays rays;
  vec3 radiance[R];
  vec2 inside[R];
  int slot[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const uvec3 place = rayPlace(tile, r);
    rays.isActive[r] = all(lessThan(place.xy, pass.part.zw));
    slot[r] = rays.isActive[r] ? sampleSlot(place) : 0;
    const uvec2 pixel = pass.region.xy + place.xy;
    const vec2 film = CENTRES ? vec2(pixel) + 0.5 : filmPosition(pixel, pass.firstSample + place.z);
    inside[r] = insidePixel(film, pixel);
    const vec2 aperture = HAS_LENS ? randomPair(r, 1u) : vec2(0.0);
    rays.origin[r] = cameraOrigin(film, aperture);
    rays.direction[r] = cameraDirection(film, aperture);
    rays.tmin[r] = params.tmin;
    rays.tmax[r] = params.tmax;
    radiance[r] = vec3(0.0);
    if (MANY_LIGHTS && pass.firstDispatch == 0u) radiance[r] = texelFetch(sampleTexels, slot[r]).rgb;
  }

  Hits hits;
  if (HAS_HITS && HAS_LENS) {
    hits = closest(rays);
  } else if (HAS_HITS) {
    hits = closestFromOne(rays);
  } else {
    FOR_RAYS (uint r = 0u; r < R; ++r) hits.slot[r] = NO_HIT;
  }
  integrate(rays, hits, radiance);

  const bool writes = !WALKS_PORTIONS || pass.portion == ALL_ANSWERED;
  if (!writes) atomicMax(status.queries, queries);
  const bool last = !MANY_LIGHTS || pass.lastDispatch != 0u;
  uint dropped = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const bool keep = !last || usable(radiance[r]);
    const uvec2 corePixel = pass.region.xy + rayPlace(tile, r).xy - pass.core.xy;
    dropped += writes && !keep && rays.isActive[r] && all(lessThan(corePixel, pass.core.zw)) ? 1u : 0u;
    const vec4 result = keep ? vec4(radiance[r], inside[r].x) : vec4(0.0, 0.0, 0.0, DROPPED);
    if (writes && rays.isActive[r]) {
      samples[slot[r]] = stored(result);
      samplesY[slot[r]] = inside[r].y;
    }
  }
  if (dropped > 0u) atomicAdd(status.dropped, dropped);
  if (loopsWereCut()) atomicAdd(status.incomplete, 1u);
}
