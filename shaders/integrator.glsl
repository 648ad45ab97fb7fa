// The frame of a trace kernel: camera rays in, radiance and filter weights of each sample out. An
// integrator includes this file and defines integrate().
#include "filter.glsl"
#ifdef LAVER_PACKET
#include "packet.glsl"
#else
#include "lane.glsl"
#endif
#include "resources.glsl"
#include "sampler.glsl"
#include "surface.glsl"

// A workgroup traces a tile of 8 x 8 pixels.
layout(local_size_x = 64 / R) in;

// Adds to `radiance` what each hit sends back along its ray. In scenes with many lights it is
// called once for every few of them (pass.lights).
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]);

// Pixel of the region and sample of the pass that ray r of this invocation traces. Eight lanes
// hold 4 x 2 pixels, or a row of the tile for each of their 8 rays. Rows of tiles are permuted, so
// that threads that get one range of workgroups each get equal work.
uvec3 rayPlace(uint r) {
  const uint i = gl_LocalInvocationIndex;
  const uint row = gl_WorkGroupID.y * pass.samples.w % pass.samples.z;
  const uvec2 inside = R == 8 ? uvec2(i, r)
                              : uvec2((i & 3u) | (i >> 1 & 4u), (i >> 2 & 1u) | (i >> 3 & 6u));
  return uvec3(uvec2(gl_WorkGroupID.x, row) * 8u + inside, gl_WorkGroupID.z);
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

// Weights of a sample for the pixels around its own, per axis: offset o stands for pixel + o.
void storeWeights(uint slot, vec2 inside) {
  const uint count = samplesOfPass();
  const uint offsets = 2u * APRON + 1u;
  for (uint i = 0u; i < offsets; ++i) {
    const float centre = float(int(i) - int(APRON)) + 0.5;
    weightOf[i * count + slot] = filterWeight(inside.x - centre);
    weightOf[(offsets + i) * count + slot] = filterWeight(inside.y - centre);
  }
}

void main() {
  Rays rays;
  rays.origin = params.origin.xyz;
  vec3 radiance[R];
  vec2 inside[R];
  uint slot[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const uvec3 place = rayPlace(r);
    rays.live[r] = all(lessThan(place.xy, pass.region.zw));
    slot[r] = rays.live[r] ? (place.z * pass.region.w + place.y) * pass.region.z + place.x : 0u;
    const uvec2 pixel = pass.region.xy + place.xy;
    const vec2 film = filmPosition(pixel, pass.samples.x + place.z);
    precise vec2 offset = film - vec2(pixel);
    inside[r] = offset;
    rays.direction[r] = cameraDirection(film);
    rays.tmin[r] = params.clip.x;
    rays.tmax[r] = params.clip.y;
    radiance[r] = vec3(0.0);
  }
  if (pass.lights.z == 0u)
    FOR_RAYS (uint r = 0u; r < R; ++r) radiance[r] = radianceOf[slot[r]].rgb;

  const Hits hits = closest(rays);
  integrate(rays, hits, radiance);
  if (incomplete) atomicAdd(status.incomplete, 1u);

  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (!rays.live[r]) continue;
    vec4 result = vec4(radiance[r], 1.0);
    if (pass.lights.w != 0u) {
      const uvec2 corePixel = pass.region.xy + rayPlace(r).xy - pass.core.xy;
      if (!(finiteAndNotNegative(result.r) && finiteAndNotNegative(result.g) &&
            finiteAndNotNegative(result.b))) {
        result = vec4(0.0);
        if (all(lessThan(corePixel, pass.core.zw))) atomicAdd(status.dropped, 1u);
      }
    }
    radianceOf[slot[r]] = result;
    if (pass.lights.z != 0u) storeWeights(slot[r], inside[r]);
  }
}
