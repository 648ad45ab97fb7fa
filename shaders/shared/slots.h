// Where a pass keeps its samples: the kernels write and read them by this, and so does the host.
#ifndef LAVER_SHARED_SLOTS_H
#define LAVER_SHARED_SLOTS_H
#include "shared/layout.h"

LAVER_SHARED_BEGIN

// Slot of sample s of the pixel (x, y) of a region, in a pass of `sampleCount` samples per pixel. A
// block has the samples that are added up together, of SLOT_COLUMNS pixels of a row. Blocks follow
// each other along a row, rows follow each other. Both tracing and gathering by strips, which are
// half a block wide (film/gather_strip.glsl), therefore go through memory from front to back.
LAVER_FN uint slotOf(uint sampleCount, uvec4 region, uint x, uint y, uint s) {
  const uint inBlock = sampleCount < GATHER_SAMPLES ? sampleCount : GATHER_SAMPLES;
  const uint blocksPerRow = (region.z + SLOT_COLUMNS - 1u) / SLOT_COLUMNS;
  const uint block = (s / GATHER_SAMPLES * region.w + y) * blocksPerRow + x / SLOT_COLUMNS;
  return (block * inBlock + s % GATHER_SAMPLES) * SLOT_COLUMNS + x % SLOT_COLUMNS;
}

LAVER_SHARED_END

#endif
