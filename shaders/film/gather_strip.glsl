// Gathering on CPU drivers, APRON <= 4: an invocation sums for a strip of 4 columns, so that it
// weighs a sample once for all of them; 8 columns take twice as long to compile, and no less to run.
// The aprons' samples are those of the strips beside it, whose lanes hand them on.
#include "film/gathered.glsl"

const uint COLUMNS = 4;
const uint WIDTH = COLUMNS + 2u * APRON;

// What lane `from` has of its strip; at the end of the row of lanes, what lane `lender` read alone.
float handed(float mine, float alone, uint from, bool atEnd, uint lender) {
  const float there = subgroupShuffle(mine, from), read = subgroupShuffle(alone, lender);
  return atEnd ? read : there;
}

void hand(Weighed mine, Weighed alone, uint from, bool atEnd, uint lender, out Weighed w) {
  [[unroll]] for (uint i = 0u; i < 3u; ++i)
    w.radiance[i] = handed(mine.radiance[i], alone.radiance[i], from, atEnd, lender);
  [[unroll]] for (uint k = 0u; k < REACH; ++k) {
    w.x[k] = handed(mine.x[k], alone.x[k], from, atEnd, lender);
    w.y[k] = handed(mine.y[k], alone.y[k], from, atEnd, lender);
  }
}

// Adds samples number s of a row of pixels to what they reach of columns x to x + 3 of the region.
void addRow(inout vec4 sums[COLUMNS][REACH], int x, int row, uint s) {
  // The strip is half a block of slots. All is read at once, so that little waits for memory.
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
    // Strips of a list lie anywhere.
    [[unroll]] for (uint j = 0u; j < APRON; ++j) {
      weigh(gathered(ivec2(x + int(j) - int(APRON), row), s), w[j]);
      weigh(gathered(ivec2(x + COLUMNS + j, row), s), w[APRON + COLUMNS + j]);
    }
    [[unroll]] for (uint c = 0u; c < COLUMNS; ++c) weigh(g[c], w[APRON + c]);
  } else {
    // Lanes 0 to APRON - 1 read the apron left of lane 0, the next the one right of the last lane.
    const int end = lane < APRON ? -int(APRON) : int(8u * COLUMNS - APRON);
    Weighed alone;
    weigh(gathered(ivec2(x + int(lane) - int(lane * COLUMNS) + end, row), s), alone);
    [[unroll]] for (uint c = 0u; c < COLUMNS; ++c) weigh(g[c], w[APRON + c]);
    [[unroll]] for (uint j = 0u; j < APRON; ++j) {
      hand(w[COLUMNS + j], alone, lane - 1u & 7u, lane == 0u, j, w[j]);
      hand(w[APRON + j], alone, lane + 1u & 7u, lane == 7u, APRON + j, w[APRON + COLUMNS + j]);
    }
  }
  [[unroll]] for (uint c = 0u; c < COLUMNS; ++c)
    [[unroll]] for (uint k = 0u; k < REACH; ++k) addSample(sums[c], w[c + k], 2u * APRON - k);
}
