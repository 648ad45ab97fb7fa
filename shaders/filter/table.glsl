// Any filter, by Nori's table: 32 weights over the radius, and a 33rd of 0.
#include "filter/away.glsl"

void filterWeights(float x, out float w[REACH]) {
  [[unroll]] for (uint k = 0u; k < REACH; ++k) {
    const float away = awayFrom(x, k);
    const uint i = min(uint(floor(abs(away) * (32.0 / params.filterRadius))), 32u);
    w[k] = params.filterTable[i / 4u][i % 4u];
  }
}
