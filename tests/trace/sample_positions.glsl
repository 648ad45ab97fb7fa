// Film positions and further pairs of the samples of the region, as in the trace kernels: pixels row by row,
// with all samples of a pixel in sequence. core.x is the dimension of the further pair.
#include "sampler/sampler.glsl"

layout(local_size_x = 64) in;
layout(binding = BINDINGS) writeonly buffer PositionBlock { vec4 positionOf[]; };

void main() {
  const uint n = gl_GlobalInvocationID.x;
  const uint place = n / pass.sampleCount;
  if (place >= pass.region.z * pass.region.w) return;
  const uvec2 pixel = pass.region.xy + uvec2(place % pass.region.z, place / pass.region.z);
  const uint number = pass.firstSample + n % pass.sampleCount;
  positionOf[n] = vec4(filmPosition(pixel, number), samplePair(pixel, number, pass.core.x));
}
