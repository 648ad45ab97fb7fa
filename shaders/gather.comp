#version 460
#extension GL_GOOGLE_include_directive : require
// Reconstruction: adds, for each pixel of the core, the samples of the pass around it to running
// sums. Sample index outer, neighbours row by row inside; each index ends in one compensated sum
// (Neumaier's two-sum, Knuth TAOCP 4.2.2), so splitting a render into passes changes no bit.
#include "resources.glsl"

layout(local_size_x = GATHER_GROUP_X, local_size_y = GATHER_GROUP_Y) in;

void addCompensated(inout FilmPixel pixel, vec4 x) {
  precise vec4 sum = pixel.sum + x;
  precise vec4 before = sum - x;
  precise vec4 error = (pixel.sum - before) + (x - (sum - before));
  precise vec4 rest = pixel.rest + error;
  pixel.sum = sum;
  pixel.rest = rest;
}

void main() {
  const uvec2 place = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(place, pass.core.zw))) return;
  const ivec2 size = ivec2(pass.region.zw);
  const ivec2 centre = ivec2(pass.core.xy + place - pass.region.xy);
  const int count = int(samplesOfPass());
  const int apron = int(APRON);

  FilmPixel pixel = filmPixels[place.y * pass.core.z + place.x];
  for (int s = 0; s < int(pass.samples.y); ++s) {
    vec4 sum = vec4(0.0);
    for (int dy = -apron; dy <= apron; ++dy) {
      for (int dx = -apron; dx <= apron; ++dx) {
        const ivec2 at = centre + ivec2(dx, dy);
        const bool exists = all(greaterThanEqual(at, ivec2(0))) && all(lessThan(at, size));
        const ivec2 safe = exists ? at : centre;
        const int slot = (s * size.y + safe.y) * size.x + safe.x;
        const vec4 value = texelFetch(radianceTexels, slot);
        // This pixel stands at offset -d of the sample's own.
        const float wx = texelFetch(weightTexels, (apron - dx) * count + slot).r;
        const float wy = texelFetch(weightTexels, (apron + 1 + apron + apron - dy) * count + slot).r;
        precise float w = exists ? wx * wy * value.a : 0.0;
        precise vec4 term = vec4(value.rgb * w, w);
        precise vec4 next = sum + term;
        sum = next;
      }
    }
    addCompensated(pixel, sum);
  }
  filmPixels[place.y * pass.core.z + place.x] = pixel;
}
