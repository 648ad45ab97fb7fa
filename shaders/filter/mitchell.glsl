// Mitchell and Netravali 1988; the outer piece is factored at its double root 2. Precise, as all weights are,
// so that every kernel sums to the same bits. params.filterShape: B, C.
float filterAt(float x) {
  const float B = params.filterShape.x, C = params.filterShape.y;
  precise float s = abs(2.0 * x / params.filterRadius);
  precise float y = max(2.0 - s, 0.0);
  precise float inner = ((12.0 - 9.0 * B - 6.0 * C) * s + (-18.0 + 12.0 * B + 6.0 * C)) * s * s +
                        (6.0 - 2.0 * B);
  precise float outer = y * y * ((B + 6.0 * C) * y - 6.0 * C);
  precise float result = (s < 1.0 ? inner : outer) / 6.0;
  return result;
}
#include "filter/weights.glsl"
