// Reconstruction: for each pixel of the core, adds the samples of the pass around it to running sums. An
// invocation goes down a column and keeps one sum per row that the samples of the current row reach, so that
// it reads each sample of a column once. Order of summation: rows outermost, then GATHER_SAMPLES samples of a
// pixel, then columns; that sum is added with compensation (Neumaier; Knuth's two-sum, TAOCP 4.2.2).

layout(local_size_x = GATHER_GROUP / COLUMNS) in;

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

// First column, index of the strip of rows, samples of the pass.
uvec3 stripOf() {
  if (!ADAPTIVE)
    return uvec3(pass.part.x + gl_GlobalInvocationID.x * COLUMNS, gl_WorkGroupID.y, pass.sampleCount);
  const uint column = groupNumber() * GATHER_GROUP + gl_LocalInvocationID.x * COLUMNS;
  const uvec3 work = listedWork(column / STRIP_COLUMNS);
  return uvec3(work.x * STRIP_COLUMNS + column % STRIP_COLUMNS, work.yz);
}

void main() {
  const int apron = int(APRON);
  const ivec4 part = ivec4(pass.part);
  const ivec2 shift = ivec2(pass.core.xy) - ivec2(pass.region.xy);
  // A strip starts at a block of slots or at half of one (sampleSlot).
  const uvec3 strip = stripOf();
  const int column = int(strip.x) - (shift.x & int(COLUMNS - 1u));
  const int first = part.y + int(strip.y * pass.stripRows);
  const int end = min(first + int(pass.stripRows), part.w);

  writtenSlot = sampleSlot(uvec3(part.xy + shift, 0));
  for (uint group = 0u; group < strip.z; group += GATHER_SAMPLES) {
    const uint groupEnd = min(group + GATHER_SAMPLES, strip.z);
    vec4 sums[COLUMNS][REACH];  // of rows row - apron to row + apron
    [[unroll]] for (uint c = 0u; c < COLUMNS; ++c)
      [[unroll]] for (uint k = 0u; k < REACH; ++k) sums[c][k] = vec4(0.0);
    for (int row = first - apron; row < end + apron; ++row) {
      // `do … while`: lavapipe copies all sums once more for a `while` loop.
      uint s = group;
      do addRow(sums, column + shift.x, row + shift.y, s); while (++s < groupEnd);
      const int done = row - apron;
      [[unroll]] for (uint c = 0u; c < COLUMNS; ++c) {
        const int x = column + int(c);
        if (done >= first && x >= part.x && x < part.z)
          addCompensated(uint(done) * pass.core.z + uint(x), sums[c][0]);
        [[unroll]] for (uint k = 1u; k < REACH; ++k) sums[c][k - 1u] = sums[c][k];
        sums[c][REACH - 1u] = vec4(0.0);
      }
    }
  }
}
