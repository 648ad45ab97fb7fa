// Gathering on any device: an invocation reads all samples that it needs.
#ifndef LAVER_GATHER_LANE
#define LAVER_GATHER_LANE
#include "gathered.glsl"

// The most samples of the pass that a place of a row which column x reaches has.
uint mostNear(int x, int row) {
  uint most = samplesAt(x + int(APRON), row);
  for (int at = x - int(APRON); at < x + int(APRON); at += int(CELL))
    most = max(most, samplesAt(at, row));
  return most;
}

// Adds samples number s of a row of pixels to what they reach of column x of the region.
void addRow(inout vec4 sums[REACH], int x, int row, uint s) {
  for (uint i = 0u; i < REACH; ++i) {
    float wx[REACH], wy[REACH];
    const vec3 radiance = gathered(x + int(i) - int(APRON), row, s, wx, wy);
    addSample(sums, radiance, wx[2u * APRON - i], wy);
  }
}

#endif
