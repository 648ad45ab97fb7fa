// Light transport without a maximum of bounces, by sampling the BSDF: point lights are not found.
const bool SAMPLES_SOURCES = false;
const bool SAMPLES_BSDF = true;
const bool SHOWS_EMISSION = true;
const uint MAX_BOUNCES = 0u;
const bool ONLY_DISCRETE = false;
#include "integrators/path.glsl"
