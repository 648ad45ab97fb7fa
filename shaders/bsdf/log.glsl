// Logarithms and powers: drivers' own may be off by some thousand ulp.
#include "filter/exp.glsl"

// The natural logarithm of a normal x > 0, within 3 ulp or 2^-24: ln x = e ln 2 + 2 artanh(s), where the
// mantissa lies in [sqrt(1/2), sqrt(2)) and |s| < 0.172; the series' first term left out is below 2 s^11 / 11
// = 7e-10.
float logOf(float x) {
  const uint bits = floatBitsToUint(x);
  const uint steps = (bits - 0x3f3504f3u) >> 23;  // sqrt(1/2)
  const float mantissa = uintBitsToFloat(bits - (steps << 23));
  const float exponent = float(int(steps << 23) >> 23);
  precise float s = (mantissa - 1.0) / (mantissa + 1.0);
  precise float s2 = s * s;
  precise float series = s * (2.0 + s2 * (2.0 / 3.0 + s2 * (0.4 + s2 * (2.0 / 7.0 + s2 * (2.0 / 9.0)))));
  precise float result = exponent * 0.69314718 + series;
  return result;
}

// 1 - exp(-x) for x >= 0, whose digits are lost where x is small.
float oneMinusExp(float x) {
  if (x > 0.03125) return 1.0 - expOf(-lesser(x, 87.0));
  return x * (1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0)));  // off by x^4 / 120 < 1e-8
}

// (1 - cosine)^5, of Schlick's approximation.
float schlickOf(float cosine) {
  const float x = 1.0 - cosine;
  const float x2 = x * x;
  return x2 * x2 * x;
}
