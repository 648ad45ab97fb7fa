// Reconstruction filters, one axis. `x` is the distance from the pixel's centre in pixels.
// params.filterArgs: radius; gaussian: alpha, exp(alpha radius^2); Mitchell: B, C.
#ifndef LAVER_FILTER
#define LAVER_FILTER
#include "resources.glsl"

#extension GL_EXT_control_flow_attributes : require

// exp(x) for |x| <= 87 within 2 ulp; drivers' exp is off by up to 29. exp(x) = 2^n exp(r),
// |r| <= ln 2 / 2, where the Taylor polynomial of degree 7 is off by r^8 / 8! < 6e-9.
float expOf(float x) {
  precise float n = floor(x * 1.44269504 + 0.5);
  precise float r = (x - n * 0.693359375) + n * 2.12194440e-4;
  // Estrin's order, so that few products wait for each other.
  precise float r2 = r * r;
  precise float low = r * 0.5 + 1.0;
  precise float middle = (r * (1.0 / 24.0) + 1.0 / 6.0);
  precise float high = (r * (1.0 / 720.0) + 1.0 / 120.0) + r2 * (1.0 / 5040.0);
  precise float result = ((middle + r2 * high) * r2 * r + low * r) + 1.0;
  return result * uintBitsToFloat(uint(int(n) + 127) << 23);
}

float gaussian(float x) {
  const float a = max(params.filterArgs.y * x * x, -87.0);
  return max(0.0, expOf(a) - params.filterArgs.z);
}

// Mitchell and Netravali 1988; the outer piece is written around its double root at 2. Precise, as
// all weights are: then kernels that know the filter sum to the same bits as those that do not.
float mitchell(float x) {
  const float B = params.filterArgs.y, C = params.filterArgs.z;
  precise float s = abs(2.0 * x / params.filterArgs.x);
  precise float y = max(2.0 - s, 0.0);
  precise float inner = ((12.0 - 9.0 * B - 6.0 * C) * s + (-18.0 + 12.0 * B + 6.0 * C)) * s * s +
                        (6.0 - 2.0 * B);
  precise float outer = y * y * ((B + 6.0 * C) * y - 6.0 * C);
  precise float result = (s < 1.0 ? inner : outer) / 6.0;
  return result;
}

// For the pixel `k` - APRON from the sample's own.
float filterWeight(float fromOwn, uint k) {
  precise float x = fromOwn - (float(k) - float(APRON));
  const float radius = params.filterArgs.x;
  if (NORI_TABLE) {
    const uint i = min(uint(floor(abs(x) * (32.0 / radius))), 32u);
    return params.table[i / 4][i % 4];
  }
  float w = 1.0;  // box
  if (FILTER == FILTER_GAUSSIAN || FILTER == FILTER_GAUSSIAN_NARROW) w = gaussian(x);
  if (FILTER == FILTER_MITCHELL) w = mitchell(x);
  precise float tent = max(0.0, 1.0 - abs(x / radius));
  if (FILTER == FILTER_TENT) w = tent;
  return abs(x) <= radius ? w : 0.0;
}

// Weights of one sample, `x` from its own pixel's centre, for the pixels at -APRON to APRON. Those
// of a gaussian share their exponentials: exp(alpha (x - k)^2) is exp(alpha x^2) times
// exp(-2 alpha x)^k times exp(alpha k^2), which stands in params.table[k].
void filterWeights(float x, out float w[REACH]) {
  if (FILTER != FILTER_GAUSSIAN_NARROW || NORI_TABLE) {
    [[unroll]] for (uint k = 0u; k < REACH; ++k) w[k] = filterWeight(x, k);
    return;
  }
  const float alpha = params.filterArgs.y;
  const bool dropped = abs(x) > 1.0;
  const float inside = dropped ? 0.0 : x;
  precise float up = expOf(-2.0 * alpha * inside);
  precise float down = 1.0 / up;
  precise float right = dropped ? 0.0 : expOf(alpha * inside * inside), left = right;
  w[APRON] = right;
  [[unroll]] for (uint k = 1u; k <= APRON; ++k) {
    right *= up;
    left *= down;
    const float centre = params.table[k / 4u][k % 4u];
    w[APRON + k] = right * centre;
    w[APRON - k] = left * centre;
  }
  // Beyond the radius a weight is below zero, as all are of a sample that is DROPPED.
  [[unroll]] for (uint k = 0u; k < REACH; ++k) w[k] = max(w[k] - params.filterArgs.z, 0.0);
}

#endif
