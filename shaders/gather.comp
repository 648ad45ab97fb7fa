#version 460
#extension GL_GOOGLE_include_directive : require
// Reconstruction: adds, for each pixel of the core, the samples of the pass around it to running
// sums. An invocation goes down a column and keeps a sum for each row that the samples of the
// present one reach, so that a sample is read once a column. Rows outer, GATHER_SAMPLES samples of
// a pixel, columns inner; then one compensated sum (Neumaier's two-sum, Knuth TAOCP 4.2.2).
#ifdef LAVER_PACKET
#include "gather_packet.glsl"
#else
#include "gather_lane.glsl"
#endif

layout(local_size_x = GATHER_GROUP) in;

void addCompensated(uint at, vec4 x) {
  FilmPixel pixel = filmPixels[at];
  precise vec4 sum = pixel.sum + x;
  precise vec4 before = sum - x;
  precise vec4 error = (pixel.sum - before) + (x - (sum - before));
  precise vec4 rest = pixel.rest + error;
  pixel.sum = sum;
  pixel.rest = rest;
  filmPixels[at] = pixel;
}

// Which columns, which rows, how many samples of the pass.
uvec3 gatherBlock() {
  if (ADAPTIVE) return listedWork();
  return uvec3(gl_WorkGroupID.xy, pass.samples.y);
}

void main() {
  const int apron = int(APRON);
  const ivec2 core = ivec2(pass.core.zw);
  const ivec2 shift = ivec2(pass.core.xy) - ivec2(pass.region.xy);
  const uvec3 block = gatherBlock();
  const int column = int(block.x * GATHER_GROUP + gl_LocalInvocationID.x);
  const int first = int(block.y * pass.tiles.x);
  const int end = min(first + int(pass.tiles.x), core.y);

  for (uint group = 0u; group < block.z; group += GATHER_SAMPLES) {
    const uint groupEnd = min(group + GATHER_SAMPLES, block.z);
    vec4 sums[REACH];  // of rows row - apron to row + apron
    [[unroll]] for (uint k = 0u; k < REACH; ++k) sums[k] = vec4(0.0);
    for (int row = first - apron; row < end + apron; ++row) {
      uint rowEnd = groupEnd;
      if (ADAPTIVE) rowEnd = min(rowEnd, mostNear(column + shift.x, row + shift.y));
      for (uint s = group; s < rowEnd; ++s) addRow(sums, column + shift.x, row + shift.y, s);
      const int done = row - apron;
      if (done >= first && column < core.x) addCompensated(uint(done * core.x + column), sums[0]);
      [[unroll]] for (uint k = 1u; k < REACH; ++k) sums[k - 1u] = sums[k];
      sums[REACH - 1u] = vec4(0.0);
    }
  }
}
