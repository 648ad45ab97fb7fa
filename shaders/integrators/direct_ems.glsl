// Emission and direct light, by light sampling.
const bool SAMPLES_SOURCES = true;
const bool SAMPLES_BSDF = false;
const bool SHOWS_EMISSION = true;
const uint MAX_BOUNCES = 1u;
const bool ONLY_DISCRETE = false;
#include "integrators/path.glsl"
