// A photon map has the expectation of paths, but for its blur.
const float xml_max_depth = 0.0;
#include "integrators/path_mis.glsl"
