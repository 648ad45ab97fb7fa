// From `x` to the pixel of weight k, in pixels. A function: the optimiser that unrolls a loop drops
// `precise` from what stands in it.
float awayFrom(float x, uint k) {
  precise float away = x - (float(k) - float(APRON));
  return away;
}
