// Light transport without a maximum of bounces, by light sampling and by sampling the BSDF.
const bool SAMPLES_SOURCES = true;
const bool SAMPLES_BSDF = true;
const bool SHOWS_EMISSION = true;
const uint MAX_BOUNCES = 0u;
const bool ONLY_DISCRETE = false;
#include "integrators/path.glsl"
