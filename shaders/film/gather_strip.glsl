// Gathering on CPU drivers, APRON <= 4: an invocation sums for a strip of 4 columns, so that it computes a
// sample's weights once for all of them. (Strips of 8 columns take twice as long to compile and are no
// faster.) Samples of the apron belong to neighbouring strips, whose lanes pass them on.
#include "film/gathered.glsl"

const uint COLUMNS = 4;
const uint WIDTH = COLUMNS + 2u * APRON;

// The value of lane `from`; at either end of the row of lanes, the value that lane `lender` has read from
// beyond the row.
float fromLaneOrBeyond(float mine, float beyondRow, uint from, bool atEnd, uint lender) {
  const float there = subgroupShuffle(mine, from), read = subgroupShuffle(beyondRow, lender);
  return atEnd ? read : there;
}

void shareWeighed(Weighed mine, Weighed beyondRow, uint from, bool atEnd, uint lender, out Weighed w) {
  [[unroll]] for (uint i = 0u; i < 3u; ++i)
    w.radiance[i] = fromLaneOrBeyond(mine.radiance[i], beyondRow.radiance[i], from, atEnd, lender);
  [[unroll]] for (uint k = 0u; k < REACH; ++k) {
    w.x[k] = fromLaneOrBeyond(mine.x[k], beyondRow.x[k], from, atEnd, lender);
    w.y[k] = fromLaneOrBeyond(mine.y[k], beyondRow.y[k], from, atEnd, lender);
  }
}

// Adds sample s of each pixel of a row to the sums of columns x to x + 3 of the region.
void addRow(inout vec4 sums[COLUMNS][REACH], int x, int row, uint s) {
  // The strip is half a block of slots. All its samples are read at once, which hides the latency of memory.
  const int start = inRegion(x, row) ? sampleSlot(uvec3(x, row, s)) : writtenSlot;
  const vec4 inY = texelFetch(sampleYTexels, start / 4);
  Gathered g[COLUMNS];
  [[unroll]] for (uint c = 0u; c < COLUMNS; ++c)
    g[c] = gathered(ivec2(x + c, row), s,
                    texelFetch(sampleTexels, inRegion(x + int(c), row) ? start + int(c) : writtenSlot),
                    inY[c]);

  Weighed w[WIDTH];
  const uint lane = gl_SubgroupInvocationID;
  if (ADAPTIVE) {
    // The strips of a work list need not be neighbours.
    [[unroll]] for (uint j = 0u; j < APRON; ++j) {
      weigh(gathered(ivec2(x + int(j) - int(APRON), row), s), w[j]);
      weigh(gathered(ivec2(x + COLUMNS + j, row), s), w[APRON + COLUMNS + j]);
    }
    [[unroll]] for (uint c = 0u; c < COLUMNS; ++c) weigh(g[c], w[APRON + c]);
  } else {
    // Lanes 0 to APRON - 1 read the apron left of lane 0, the next APRON lanes the one right of the last
    // lane.
    const int end = lane < APRON ? -int(APRON) : int(8u * COLUMNS - APRON);
    Weighed beyondRow;
    weigh(gathered(ivec2(x + int(lane) - int(lane * COLUMNS) + end, row), s), beyondRow);
    [[unroll]] for (uint c = 0u; c < COLUMNS; ++c) weigh(g[c], w[APRON + c]);
    [[unroll]] for (uint j = 0u; j < APRON; ++j) {
      shareWeighed(w[COLUMNS + j], beyondRow, lane - 1u & 7u, lane == 0u, j, w[j]);
      shareWeighed(w[APRON + j], beyondRow, lane + 1u & 7u, lane == 7u, APRON + j, w[APRON + COLUMNS + j]);
    }
  }
  [[unroll]] for (uint c = 0u; c < COLUMNS; ++c)
    [[unroll]] for (uint k = 0u; k < REACH; ++k) addSample(sums[c], w[c + k], 2u * APRON - k);
}
