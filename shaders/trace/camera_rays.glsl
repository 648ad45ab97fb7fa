// The samples that an invocation traces, and their random numbers.
#include "film/adaptive.glsl"
#include "trace/rays.glsl"
#include "sampler/sampler.glsl"

// A workgroup traces 64 samples: one of each pixel of an 8 x 8 tile, or several of each pixel of a smaller
// tile, side by side.
layout(local_size_x = 64 / R) in;

// First pixel and sample of the workgroup's tile. Rows of tiles are permuted, so that threads that get
// consecutive workgroups each get a similar amount of work.
uvec3 tileOrigin() {
  if (ADAPTIVE) return listedWork(groupNumber());
  const uint row = gl_WorkGroupID.y * pass.rowStride % pass.tileRows;
  return uvec3(pass.part.xy + uvec2(gl_WorkGroupID.x, row) * (8u >> (pass.sideShift >> 1)),
               pass.dispatchSample + (gl_WorkGroupID.z << pass.sideShift));
}

// Pixel of the region and sample of the pass that ray r of this invocation traces. Pixels of a tile are in
// Morton order, so that the rays of a lane are close together.
uvec3 rayPlace(uvec3 tile, uint r) {
  const uint number = gl_LocalInvocationIndex * R + r;
  const uint sampleNumber = number & ((1u << pass.sideShift) - 1u);
  const uint m = number >> pass.sideShift;
  const uvec2 inside = uvec2((m & 1u) | (m >> 1 & 2u) | (m >> 2 & 4u),
                             (m >> 1 & 1u) | (m >> 2 & 2u) | (m >> 3 & 4u));
  return tile + uvec3(inside, sampleNumber);
}

// The random pair of dimension `dimension` in [0, 1)^2 for the sample of ray r. Dimension 1 is the
// aperture's.
vec2 randomPair(uint r, uint dimension) {
  const uvec3 place = rayPlace(tileOrigin(), r);
  return samplePair(pass.region.xy + place.xy, pass.firstSample + place.z, dimension);
}
