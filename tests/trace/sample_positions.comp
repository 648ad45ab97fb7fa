#version 460
#extension GL_GOOGLE_include_directive : require
// Film positions and two more numbers of the samples of the region, as the trace kernels place them:
// pixels row by row, all samples of one after the other.
#include "sampler.glsl"

layout(local_size_x = 64) in;
layout(binding = BINDINGS) writeonly buffer PositionBlock { vec4 positionOf[]; };

void main() {
  const uint n = gl_GlobalInvocationID.x;
  const uint place = n / pass.samples.y;
  if (place >= pass.region.z * pass.region.w) return;
  const uvec2 pixel = pass.region.xy + uvec2(place % pass.region.z, place / pass.region.z);
  const uint number = pass.samples.x + n % pass.samples.y;
  positionOf[n] = vec4(filmPosition(pixel, number), aperturePosition(pixel, number));
}
