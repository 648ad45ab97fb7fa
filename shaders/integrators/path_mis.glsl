// Light transport by light sampling and by sampling the BSDF, along at most `max_depth` surfaces; 0: any
// number.
const bool SAMPLES_SOURCES = true;
const bool SAMPLES_BSDF = true;
const bool SHOWS_EMISSION = true;
#define MAX_BOUNCES uint(xml_max_depth)
const bool ONLY_DISCRETE = false;
#include "integrators/path.glsl"
