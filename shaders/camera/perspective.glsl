// A pinhole camera: the ray through a film position given in pixels.
#include "camera/pinhole.glsl"

const bool HAS_LENS = false;

vec3 cameraOrigin(vec2 film, vec2 numbers) { return pinholeOrigin(film); }

vec3 cameraDirection(vec2 film, vec2 numbers) { return pinholeDirection(film); }
