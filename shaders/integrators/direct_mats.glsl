// Emission and direct light, by sampling the BSDF: point lights are not found.
const bool SAMPLES_SOURCES = false;
const bool SAMPLES_BSDF = true;
const bool SHOWS_EMISSION = true;
const uint MAX_BOUNCES = 1u;
const bool ONLY_DISCRETE = false;
#include "integrators/path.glsl"
