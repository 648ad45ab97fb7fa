// A sample as gathering sees it.
#ifndef LAVER_GATHERED
#define LAVER_GATHERED
#include "adaptive.glsl"
#include "filter.glsl"

// Sample s of a pixel of the region: radiance and place; none outside the region.
struct Gathered {
  vec4 value;
  float inY;
  float share;  // what it counts for, where pixels have counts of their own
};

bool inRegion(int x, int y) {
  return x >= 0 && y >= 0 && x < int(pass.region.z) && y < int(pass.region.w);
}

Gathered gathered(uvec2 place, uint s, int slot, bool exists) {
  Gathered g;
  g.value = texelFetch(sampleTexels, slot);
  g.inY = texelFetch(sampleYTexels, slot).r;
  if (!exists) g.value.w = DROPPED;
  if (ADAPTIVE) {
    // Where nothing was traced lies what an earlier pass left, or nothing yet.
    g.share = shareOf(place, s);
    g.value = g.share > 0.0 ? g.value : vec4(0.0, 0.0, 0.0, DROPPED);
    g.inY = g.share > 0.0 ? g.inY : 0.0;
  }
  return g;
}

// Its weights for the pixels at -APRON to APRON on both axes.
void weigh(Gathered g, out float wx[REACH], out float wy[REACH]) {
  filterWeights(g.value.w - 0.5, wx);
  filterWeights(g.inY - 0.5, wy);
  if (ADAPTIVE)
    [[unroll]] for (uint k = 0u; k < REACH; ++k) wy[k] *= g.share;
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
