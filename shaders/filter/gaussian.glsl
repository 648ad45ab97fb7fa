// exp(alpha x^2) - exp(alpha radius^2). params.filterShape: alpha, the second term.
#include "filter/exp.glsl"

float filterAt(float x) {
  const float a = max(params.filterShape.x * x * x, -87.0);
  return max(0.0, expOf(a) - params.filterShape.y);
}
#include "filter/weights.glsl"
