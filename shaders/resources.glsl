// What the kernels read and write.
#ifndef LAVER_RESOURCES
#define LAVER_RESOURCES
#include "shared/layout.h"

#ifdef LAVER_PLAIN
#define CONSTANT(id) const
#else
#define CONSTANT(id) layout(constant_id = id) const
#define PLAIN_NORMALS 1
#define PLAIN_ALBEDOS 1
#endif
CONSTANT(SPEC_STACK) uint STACK = PLAIN[SPEC_STACK];
CONSTANT(SPEC_NORMALS) bool HAS_NORMALS = bool(PLAIN_NORMALS);
CONSTANT(SPEC_ALBEDOS) bool HAS_ALBEDOS = bool(PLAIN_ALBEDOS);
CONSTANT(SPEC_LIGHTS) uint LIGHTS = PLAIN[SPEC_LIGHTS];
layout(constant_id = SPEC_JUMP_LEVELS) const uint JUMP_LEVELS = 3;
CONSTANT(SPEC_FILTER) uint KNOWN_FILTER = PLAIN[SPEC_FILTER];
CONSTANT(SPEC_APRON) uint APRON = PLAIN[SPEC_APRON];
CONSTANT(SPEC_NORI_TABLE) bool NORI_TABLE = bool(PLAIN[SPEC_NORI_TABLE]);
CONSTANT(SPEC_SAMPLER) uint SAMPLER = PLAIN[SPEC_SAMPLER];
CONSTANT(SPEC_ADAPTIVE) bool ADAPTIVE = bool(PLAIN[SPEC_ADAPTIVE]);
// Of kernels with LAVER_TEXTURES alone, which scenes without textures and background do not use:
// to leave the code out by these constants takes drivers 10 to 20 ms of their compiling.
layout(constant_id = SPEC_TEXTURES) const uint TEXTURES = 3;
layout(constant_id = SPEC_IMAGES) const uint IMAGES = 3;
layout(constant_id = SPEC_BACKGROUND) const uint BACKGROUND = BACKGROUND_IMAGE;
CONSTANT(SPEC_HITS) bool HAS_HITS = bool(PLAIN[SPEC_HITS]);
CONSTANT(SPEC_DARK_SIDES) bool DARK_SIDES = bool(PLAIN[SPEC_DARK_SIDES]);

const uint REACH = 2u * APRON + 1u;  // pixels on an axis that one sample reaches

layout(std140, binding = BIND_PARAMS) uniform ParamsBlock { Params params; };
#define FILTER \
  (KNOWN_FILTER == FILTER_AT_RUN_TIME ? uint(params.filterArgs.w) : KNOWN_FILTER)
layout(push_constant) uniform PassBlock { Pass pass; };

// uvec4 texels: floats keep their bits, denormals and NaN patterns included.
layout(binding = BIND_NODES) uniform usamplerBuffer nodeTexels;
layout(binding = BIND_TRIANGLES) uniform usamplerBuffer triangleTexels;
layout(binding = BIND_ATTRIBUTES) uniform usamplerBuffer attributeTexels;
layout(binding = BIND_NORMALS) uniform usamplerBuffer normalTexels;
layout(binding = BIND_MATERIALS) uniform usamplerBuffer materialTexels;
layout(binding = BIND_LIGHTS) uniform usamplerBuffer lightTexels;
layout(binding = BIND_JUMPS) uniform usamplerBuffer jumpTexels;
layout(binding = BIND_SAMPLES, rgba32f) uniform writeonly imageBuffer samples;
layout(binding = BIND_SAMPLES_Y, r32f) uniform writeonly imageBuffer samplesY;
layout(binding = BIND_FILM) buffer FilmBlock { FilmPixel filmPixels[]; };
layout(binding = BIND_STATUS) buffer StatusBlock { Status status; };
layout(binding = BIND_SAMPLE_TEXELS) uniform samplerBuffer sampleTexels;
layout(binding = BIND_SAMPLE_Y_TEXELS) uniform samplerBuffer sampleYTexels;
layout(binding = BIND_COUNTS) uniform usamplerBuffer countTexels;
layout(binding = BIND_WORK) uniform usamplerBuffer workTexels;
layout(binding = BIND_TEXTURES) uniform usamplerBuffer textureTexels;
layout(binding = BIND_UVS) uniform usamplerBuffer uvTexels;
layout(binding = BIND_IMAGES) uniform usamplerBuffer imageTexels;

vec3 texelVec3(uvec4 texel) { return uintBitsToFloat(texel.xyz); }

// Where sample s of region pixel (x, y) lies: in columns as wide as what a group gathers, so that it
// goes through memory from front to back.
int sampleSlot(uvec3 xys) {
  const bool whole = pass.samples.y >= GATHER_SAMPLES;
  const uint unit = whole ? GATHER_SAMPLES : pass.samples.y;
  const uint units = whole ? (pass.samples.y + GATHER_SAMPLES - 1u) / GATHER_SAMPLES : 1u;
  const uint number = whole ? xys.z / GATHER_SAMPLES : 0u;
  const uint block = (xys.x / GATHER_GROUP * units + number) * pass.region.w + xys.y;
  return int((block * unit + (xys.z - number * GATHER_SAMPLES)) * GATHER_GROUP + xys.x % GATHER_GROUP);
}

#endif
