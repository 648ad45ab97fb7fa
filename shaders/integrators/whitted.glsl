// Direct light by light sampling; discrete BSDFs such as a mirror's reflect and refract the scene.
const bool SAMPLES_SOURCES = true;
const bool SAMPLES_BSDF = false;
const bool SHOWS_EMISSION = true;
const uint MAX_BOUNCES = 0u;
const bool ONLY_DISCRETE = true;
#include "integrators/path.glsl"
