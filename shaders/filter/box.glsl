float filterAt(float x) { return 1.0; }
#include "filter/weights.glsl"
