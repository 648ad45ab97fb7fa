float filterAt(float x) {
  precise float tent = max(0.0, 1.0 - abs(x / params.filterRadius));
  return tent;
}
#include "filter/weights.glsl"
