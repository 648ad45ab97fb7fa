// A sample as gathering sees it.
#ifndef LAVER_GATHERED
#define LAVER_GATHERED
#include "adaptive.glsl"
#include "filter.glsl"

// Sample s of a pixel of the region and its weights for the pixels at -APRON to APRON on both axes;
// none outside the region.
vec3 gathered(int x, int y, uint s, out float wx[REACH], out float wy[REACH]) {
  const bool exists = x >= 0 && y >= 0 && x < int(pass.region.z) && y < int(pass.region.w);
  const uvec2 place = exists ? uvec2(x, y) : uvec2(0u);
  const int slot = sampleSlot(uvec3(place, s));
  const vec4 value = texelFetch(sampleTexels, slot);
  const float inY = texelFetch(sampleYTexels, slot).r;
  filterWeights((exists ? value.w : DROPPED) - 0.5, wx);
  filterWeights(inY - 0.5, wy);
  vec3 radiance = value.rgb;
  if (ADAPTIVE) weighByCount(place, s, radiance, wx, wy);
  return radiance;
}

// Adds one sample to the sums of the rows that it reaches.
void addSample(inout vec4 sums[REACH], vec3 radiance, float wx, float wy[REACH]) {
  [[unroll]] for (uint k = 0u; k < REACH; ++k) {
    precise float w = wx * wy[k];
    precise vec4 next = sums[k] + vec4(radiance * w, w);
    sums[k] = next;
  }
}

#endif
