// The Gaussian of small radius, whose weights are products: exp(alpha (x - k)^2) = exp(alpha x^2) exp(-2
// alpha x)^k exp(alpha k^2), of which the last factor is params.filterTable[k]. params.filterShape is as in
// filter/gaussian.glsl.
#include "filter/exp.glsl"

// A function for the reason given in filter/away.glsl.
float preciseProduct(float a, float b) {
  precise float product = a * b;
  return product;
}

void filterWeights(float x, out float w[REACH]) {
  const float alpha = params.filterShape.x;
  const bool dropped = abs(x) > 1.0;
  const float inside = dropped ? 0.0 : x;
  precise float up = expOf(-2.0 * alpha * inside);
  precise float down = 1.0 / up;
  precise float right = dropped ? 0.0 : expOf(alpha * inside * inside), left = right;
  w[APRON] = right;
  [[unroll]] for (uint k = 1u; k <= APRON; ++k) {
    right = preciseProduct(right, up);
    left = preciseProduct(left, down);
    const float centre = params.filterTable[k / 4u][k % 4u];
    w[APRON + k] = preciseProduct(right, centre);
    w[APRON - k] = preciseProduct(left, centre);
  }
  // Beyond the radius the difference is negative, and so it is for a DROPPED sample.
  [[unroll]] for (uint k = 0u; k < REACH; ++k) w[k] = max(w[k] - params.filterShape.y, 0.0);
}
