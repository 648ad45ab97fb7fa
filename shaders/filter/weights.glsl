// The weights of one sample, `x` pixels from the centre of its own pixel on one axis, for the pixels at
// -APRON to APRON. The filter defines filterAt(), its value at a distance in pixels from a pixel's centre.
#include "filter/away.glsl"

void filterWeights(float x, out float w[REACH]) {
  [[unroll]] for (uint k = 0u; k < REACH; ++k) {
    const float away = awayFrom(x, k);
    w[k] = abs(away) <= params.filterRadius ? filterAt(away) : 0.0;
  }
}
