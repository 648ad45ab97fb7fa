// Light transport by sampling the BSDF, along at most `max_depth` surfaces; 0: any number. Point lights are
// not found.
const bool SAMPLES_SOURCES = false;
const bool SAMPLES_BSDF = true;
const bool SHOWS_EMISSION = true;
#define MAX_BOUNCES uint(xml_max_depth)
const bool ONLY_DISCRETE = false;
#include "integrators/path.glsl"
