// Gathering on CPU drivers, APRON <= 4: an invocation sums for a strip of 8 columns, so that it
// weighs a sample once for all of them.
#ifndef LAVER_GATHER_STRIP
#define LAVER_GATHER_STRIP
#include "gathered.glsl"

const uint COLUMNS = SLOT_COLUMNS;

// Adds samples number s of a row of pixels to what they reach of columns x to x + 7 of the region.
void addRow(inout vec4 sums[COLUMNS][REACH], int x, int row, uint s) {
  const uint WIDTH = COLUMNS + 2u * APRON;
  // The strip's columns are a block of slots, its aprons lie in the blocks beside it.
  const int start = sampleSlot(uvec3(max(ivec2(x, row), 0), s));
  const int gap = int(slotsABlock() - SLOT_COLUMNS);
  Gathered g[WIDTH];  // read at once, so that few wait for memory
  [[unroll]] for (uint i = 0u; i < WIDTH; ++i) {
    const int offset = int(i) - int(APRON);
    const int blocks = offset < 0 ? -1 : offset < int(COLUMNS) ? 0 : 1;
    const bool exists = inRegion(x + offset, row);
    const int slot = exists ? start + offset + blocks * gap : 0;
    g[i] = gathered(exists ? uvec2(x + offset, row) : uvec2(0u), s, slot, exists);
  }
  [[unroll]] for (uint i = 0u; i < WIDTH; ++i) {
    float wx[REACH], wy[REACH];
    weigh(g[i], wx, wy);
    [[unroll]] for (uint c = 0u; c < COLUMNS; ++c)
      if (c <= i && i - c < REACH) addSample(sums[c], g[i].value.rgb, wx[2u * APRON + c - i], wy);
  }
}

#endif
