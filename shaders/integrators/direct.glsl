// Direct light by light sampling; emission itself is not seen.
const bool SAMPLES_SOURCES = true;
const bool SAMPLES_BSDF = false;
const bool SHOWS_EMISSION = false;
const uint MAX_BOUNCES = 1u;
const bool ONLY_DISCRETE = false;
#include "integrators/path.glsl"
