// Path tracing by BSDF sampling only, over at most `max_depth` surfaces (0: any number). It misses point lights.
const bool SAMPLES_SOURCES = false;
const bool SAMPLES_BSDF = true;
const bool SHOWS_EMISSION = true;
#define MAX_BOUNCES uint(xml_max_depth)
const bool ONLY_DISCRETE = false;
#include "integrators/path.glsl"
