// Distance from `x` to the pixel of weight k, in pixels, signed. It is a function because the optimiser drops
// `precise` from the body of a loop that it unrolls.
float awayFrom(float x, uint k) {
  precise float away = x - (float(k) - float(APRON));
  return away;
}
