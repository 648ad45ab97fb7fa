// Gathering on any device: an invocation sums for one column and reads all the samples that it needs.
#include "film/gathered.glsl"

const uint COLUMNS = 1u;

// Adds sample s of each pixel of a row to the sums of column x of the region.
void addRow(inout vec4 sums[COLUMNS][REACH], int x, int row, uint s) {
  for (uint i = 0u; i < REACH; ++i) {
    const int column = x + int(i) - int(APRON);
    Weighed w;
    weigh(gathered(ivec2(column, row), s), w);
    addSample(sums[0], w, 2u * APRON - i);
  }
}
