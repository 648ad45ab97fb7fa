// Reading stored samples, and their filter weights.
#include "film/adaptive.glsl"

// Sample s of a pixel of the region: value.rgb is its radiance, (value.w, inY) its position inside the pixel.
// DROPPED outside the region.
struct Gathered {
  vec4 value;
  float inY;
  float share;  // weight of the sample; 1 unless sampling is adaptive
};

bool inRegion(int x, int y) {
  return x >= 0 && y >= 0 && x < int(pass.region.z) && y < int(pass.region.w);
}

// A slot that the pass has written, read for pixels that have none: other memory may hold NaN, which no
// weight makes zero. In adaptive passes it may be unwritten; they test the sample's share instead.
int writtenSlot;

// The sample in a slot. Outside the region any written slot will do, with any inY: the weight is 0.
Gathered gathered(ivec2 place, uint s, vec4 value, float inY) {
  const bool exists = inRegion(place.x, place.y);
  Gathered g = Gathered(value, exists ? inY : 0.0, 1.0);
  if (!exists) g.value.w = DROPPED;
  if (ADAPTIVE) {
    // Slots without a sample hold stale values of an earlier pass or none at all.
    const float share = shareOf(exists ? uvec2(place) : uvec2(0u), s);
    g.share = exists ? share : 0.0;
    g.value = g.share > 0.0 ? g.value : vec4(0.0, 0.0, 0.0, DROPPED);
    g.inY = g.share > 0.0 ? g.inY : 0.0;
  }
  return g;
}

Gathered gathered(ivec2 place, uint s) {
  const int slot = inRegion(place.x, place.y) ? sampleSlot(uvec3(place, s)) : writtenSlot;
  return gathered(place, s, texelFetch(sampleTexels, slot),
                  texelFetch(sampleYTexels, slot / 4)[slot % 4]);
}

// A sample with its weights for the pixels at -APRON to APRON on both axes.
struct Weighed {
  vec3 radiance;
  float x[REACH], y[REACH];
};

void weigh(Gathered g, out Weighed w) {
  w.radiance = g.value.rgb;
  filterWeights(g.value.w - 0.5, w.x);
  filterWeights(g.inY - 0.5, w.y);
  if (ADAPTIVE)
    [[unroll]] for (uint k = 0u; k < REACH; ++k) w.y[k] *= g.share;
}

vec4 plusWeighted(vec4 sum, vec3 radiance, float wx, float wy) {
  precise float w = wx * wy;
  precise vec4 result = sum + vec4(radiance * w, w);
  return result;
}

// Adds one sample, with weight x[column] on the x axis, to the sums of the rows that it reaches.
void addSample(inout vec4 sums[REACH], Weighed sampled, uint column) {
  [[unroll]] for (uint k = 0u; k < REACH; ++k)
    sums[k] = plusWeighted(sums[k], sampled.radiance, sampled.x[column], sampled.y[k]);
}
