// Gathering where subgroups have 8 lanes and APRON <= 4: the lanes, 8 columns, read two times 8
// samples, weigh each once and hand them round.
#ifndef LAVER_GATHER_PACKET
#define LAVER_GATHER_PACKET
#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_shuffle : require
#include "gathered.glsl"

float either(bool first, float a, float b, uint from) {
  const float x = subgroupShuffle(a, from), y = subgroupShuffle(b, from);
  return first ? x : y;
}

// The most samples of the pass that a place of a row which the lanes' columns x reach has.
uint mostNear(int x, int row) {
  const int first = x - int(APRON);
  uint most = max(samplesAt(first, row), samplesAt(first + 8, row));
  [[unroll]] for (uint step = 1u; step < 8u; step *= 2u)
    most = max(most, subgroupShuffleXor(most, step));
  return most;
}

// Adds samples number s of a row of pixels to what they reach of column x of the region.
void addRow(inout vec4 sums[REACH], int x, int row, uint s) {
  float ax[REACH], ay[REACH], bx[REACH], by[REACH];
  const vec3 a = gathered(x - int(APRON), row, s, ax, ay);
  const vec3 b = gathered(x - int(APRON) + 8, row, s, bx, by);
  [[unroll]] for (uint i = 0u; i < REACH; ++i) {
    const uint at = gl_SubgroupInvocationID + i;
    const uint from = at & 7u;
    const bool first = at < 8u;
    const vec3 radiance = vec3(either(first, a.r, b.r, from), either(first, a.g, b.g, from),
                               either(first, a.b, b.b, from));
    float wy[REACH];
    [[unroll]] for (uint k = 0u; k < REACH; ++k) wy[k] = either(first, ay[k], by[k], from);
    const float wx = either(first, ax[2u * APRON - i], bx[2u * APRON - i], from);
    addSample(sums, radiance, wx, wy);
  }
}

#endif
