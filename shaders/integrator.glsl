// The frame of a trace kernel: camera rays in, radiance and place of each sample out. An integrator
// includes this file and defines integrate().
#include "adaptive.glsl"
#ifdef LAVER_PACKET
#include "packet.glsl"
#else
#include "lane.glsl"
#endif
#include "sampler.glsl"
#include "surface.glsl"

// A workgroup traces 64 samples: of a tile of 8 x 8 pixels, or more than one of each pixel of a
// smaller tile, side by side.
layout(local_size_x = 64 / R) in;

// Adds to `radiance` what each hit sends back along its ray. In scenes with many lights it is
// called once for every few of them (pass.lights).
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]);

// First pixel and sample of the workgroup's tile. Rows of tiles are permuted, so that threads that
// get one range of workgroups each get equal work.
uvec3 tileOrigin() {
  if (ADAPTIVE) return listedWork(groupNumber());
  const uint row = gl_WorkGroupID.y * pass.tiles.y % pass.tiles.x;
  return uvec3(pass.part.xy + uvec2(gl_WorkGroupID.x, row) * (8u >> (pass.tiles.z >> 1)),
               pass.tiles.w + (gl_WorkGroupID.z << pass.tiles.z));
}

// Pixel of the region and sample of the pass that ray r of this invocation traces. Pixels of a tile
// are in Morton order, so that neighbouring numbers, which are the rays of a lane, stay close.
uvec3 rayPlace(uvec3 tile, uint r) {
  const uint number = gl_LocalInvocationIndex * R + r;
  const uint sampleNumber = number & ((1u << pass.tiles.z) - 1u);
  const uint m = number >> pass.tiles.z;
  const uvec2 inside = uvec2((m & 1u) | (m >> 1 & 2u) | (m >> 2 & 4u),
                             (m >> 1 & 1u) | (m >> 2 & 2u) | (m >> 3 & 4u));
  return tile + uvec3(inside, sampleNumber);
}

// Two numbers in [0, 1) that belong to the sample of ray r.
vec2 moreNumbers(uint r) {
  const uvec3 place = rayPlace(tileOrigin(), r);
  return aperturePosition(pass.region.xy + place.xy, pass.samples.x + place.z);
}

vec3 cameraDirection(vec2 film) {
  precise float x = float(params.film.x) - 2.0 * film.x;
  precise float y = float(params.film.y) - 2.0 * film.y;
  precise vec3 d = params.columnX.xyz * x + params.columnY.xyz * y + params.columnZ.xyz;
  return d;
}

bool finiteAndNotNegative(float x) {
  const uint bits = floatBitsToUint(x);
  return bits < 0x7f800000u || bits == 0x80000000u;
}

bool usable(vec3 v) {
#ifdef LAVER_SIGNED
  v = abs(v);
#endif
  return finiteAndNotNegative(v.r) && finiteAndNotNegative(v.g) && finiteAndNotNegative(v.b);
}

void main() {
  const uvec3 tile = tileOrigin();
  Rays rays;
  rays.origin = params.origin.xyz;
  vec3 radiance[R];
  vec2 inside[R];
  int slot[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const uvec3 place = rayPlace(tile, r);
    rays.live[r] = all(lessThan(place.xy, pass.part.zw));
    slot[r] = rays.live[r] ? sampleSlot(place) : 0;
    const uvec2 pixel = pass.region.xy + place.xy;
#ifdef LAVER_CENTRES
    const vec2 film = vec2(pixel) + 0.5;
#else
    const vec2 film = filmPosition(pixel, pass.samples.x + place.z);
#endif
    inside[r] = insidePixel(film, pixel);
    rays.direction[r] = cameraDirection(film);
    rays.tmin[r] = params.clip.x;
    rays.tmax[r] = params.clip.y;
    radiance[r] = vec3(0.0);
    if (LIGHTS == LIGHTS_MANY && pass.lights.z == 0u)
      radiance[r] = texelFetch(sampleTexels, slot[r]).rgb;
  }

  Hits hits;
  if (HAS_HITS) {
    hits = closest(rays);
  } else {
    FOR_RAYS (uint r = 0u; r < R; ++r) hits.slot[r] = NO_HIT;
  }
  integrate(rays, hits, radiance);

  const bool last = LIGHTS != LIGHTS_MANY || pass.lights.w != 0u;
  uint dropped = 0u;
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const bool keep = !last || usable(radiance[r]);
    const uvec2 corePixel = pass.region.xy + rayPlace(tile, r).xy - pass.core.xy;
    dropped += !keep && rays.live[r] && all(lessThan(corePixel, pass.core.zw)) ? 1u : 0u;
    const vec4 result = keep ? vec4(radiance[r], inside[r].x) : vec4(0.0, 0.0, 0.0, DROPPED);
    if (rays.live[r]) {
      samples[slot[r]] = stored(result);
      samplesY[slot[r]] = inside[r].y;
    }
  }
  if (dropped > 0u) atomicAdd(status.dropped, dropped);
  if (loopsWereCut()) atomicAdd(status.incomplete, 1u);
}
