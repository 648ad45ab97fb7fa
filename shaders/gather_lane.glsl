// Gathering on any device: an invocation sums for one column and reads all samples that it needs.
#ifndef LAVER_GATHER_LANE
#define LAVER_GATHER_LANE
#include "gathered.glsl"

const uint COLUMNS = 1u;

// Adds samples number s of a row of pixels to what they reach of column x of the region.
void addRow(inout vec4 sums[COLUMNS][REACH], int x, int row, uint s) {
  for (uint i = 0u; i < REACH; ++i) {
    float wx[REACH], wy[REACH];
    const int column = x + int(i) - int(APRON);
    const bool exists = inRegion(column, row);
    const uvec2 place = exists ? uvec2(column, row) : uvec2(0u);
    const Gathered g = gathered(place, s, sampleSlot(uvec3(place, s)), exists);
    weigh(g, wx, wy);
    addSample(sums[0], g.value.rgb, wx[2u * APRON - i], wy);
  }
}

#endif
