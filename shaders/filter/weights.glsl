// Weights of one sample, `x` pixels from its own pixel's centre on one axis, for the pixels at -APRON to
// APRON. The kernel's filter defines filterAt(): its value at a distance from a pixel's centre, in pixels.
#include "filter/away.glsl"

void filterWeights(float x, out float w[REACH]) {
  [[unroll]] for (uint k = 0u; k < REACH; ++k) {
    const float away = awayFrom(x, k);
    w[k] = abs(away) <= params.filterRadius ? filterAt(away) : 0.0;
  }
}
