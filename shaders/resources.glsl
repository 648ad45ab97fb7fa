// What the kernels read and write.
#ifndef LAVER_RESOURCES
#define LAVER_RESOURCES
#include "shared/layout.h"

#ifdef LAVER_PLAIN
#define CONSTANT(id) const
#else
#define CONSTANT(id) layout(constant_id = id) const
#endif
// What cmake/Shaders.cmake varies, as far as a kernel reads it.
#ifndef PLAIN_NORMALS
#define PLAIN_NORMALS PLAIN[SPEC_NORMALS]
#endif
#ifndef PLAIN_ALBEDOS
#define PLAIN_ALBEDOS PLAIN[SPEC_ALBEDOS]
#endif
#ifndef PLAIN_SAMPLER
#define PLAIN_SAMPLER PLAIN[SPEC_SAMPLER]
#endif
#ifndef PLAIN_FILTER
#define PLAIN_FILTER PLAIN[SPEC_FILTER]
#endif
CONSTANT(SPEC_STACK) uint STACK = PLAIN[SPEC_STACK];
CONSTANT(SPEC_NORMALS) bool HAS_NORMALS = bool(PLAIN_NORMALS);
CONSTANT(SPEC_ALBEDOS) bool HAS_ALBEDOS = bool(PLAIN_ALBEDOS);
CONSTANT(SPEC_LIGHTS) uint LIGHTS = PLAIN[SPEC_LIGHTS];
layout(constant_id = SPEC_JUMP_LEVELS) const uint JUMP_LEVELS = 3;
CONSTANT(SPEC_FILTER) uint KNOWN_FILTER = PLAIN_FILTER;
CONSTANT(SPEC_APRON) uint APRON = PLAIN_APRON[PLAIN_FILTER];
CONSTANT(SPEC_NORI_TABLE) bool NORI_TABLE = bool(PLAIN[SPEC_NORI_TABLE]);
CONSTANT(SPEC_SAMPLER) uint SAMPLER = PLAIN_SAMPLER;
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

// A vec4 as kernels store it. lavapipe stores number by number and lane by lane, so that two 64-bit
// numbers take less time than four floats.
#ifdef LAVER_PACKET
#extension GL_ARB_gpu_shader_int64 : require
#define Stored u64vec2
Stored stored(vec4 v) {
  const uvec4 bits = floatBitsToUint(v);
  return Stored(packUint2x32(bits.xy), packUint2x32(bits.zw));
}
#else
#define Stored vec4
Stored stored(vec4 v) { return v; }
#endif

// uvec4 texels: floats keep their bits, denormals and NaN patterns included.
layout(binding = BIND_NODES) uniform usamplerBuffer nodeTexels;
layout(binding = BIND_TRIANGLES) uniform usamplerBuffer triangleTexels;
layout(binding = BIND_ATTRIBUTES) uniform usamplerBuffer attributeTexels;
layout(binding = BIND_NORMALS) uniform usamplerBuffer normalTexels;
layout(binding = BIND_MATERIALS) uniform usamplerBuffer materialTexels;
layout(binding = BIND_LIGHTS) uniform usamplerBuffer lightTexels;
layout(binding = BIND_JUMPS) uniform usamplerBuffer jumpTexels;
layout(binding = BIND_SAMPLES) writeonly buffer SamplesBlock { Stored samples[]; };
layout(binding = BIND_SAMPLES_Y) writeonly buffer SamplesYBlock { float samplesY[]; };
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

// Of SLOT_COLUMNS pixels of a row, the samples that are summed together.
uint slotsABlock() { return min(pass.samples.y, GATHER_SAMPLES) * SLOT_COLUMNS; }

// Where sample s of region pixel (x, y) lies: block after block along a row, row after row. Tracing
// goes through memory from front to back, and so do strips, which are half a block wide
// (gather_strip.glsl).
int sampleSlot(uvec3 xys) {
  const uint blocksARow = (pass.region.z + SLOT_COLUMNS - 1u) / SLOT_COLUMNS;
  const uint row = xys.z / GATHER_SAMPLES * pass.region.w + xys.y;
  const uint block = row * blocksARow + xys.x / SLOT_COLUMNS;
  return int(block * slotsABlock() + xys.z % GATHER_SAMPLES * SLOT_COLUMNS + xys.x % SLOT_COLUMNS);
}

#endif
