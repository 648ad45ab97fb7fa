// Bindings: everything that a kernel reads and writes. The constants of the kernel's key stand before
// this text (host/kernels/compose.cpp).
#include "shared/layout.h"

const uint REACH = 2u * APRON + 1u;  // pixels on an axis that one sample reaches

layout(std140, binding = BIND_PARAMS) uniform ParamsBlock { Params params; };
layout(push_constant) uniform PassBlock { Pass pass; };

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

// Samples stored in one block of SLOT_COLUMNS pixels of a row: those that are summed together.
uint slotsPerBlock() { return min(pass.sampleCount, GATHER_SAMPLES) * SLOT_COLUMNS; }

// Slot of a sample, by region pixel (x, y) and its number in the pass: block after block along a row,
// row after row. Tracing goes through memory from front to back, and so do gathering strips, which are
// half a block wide (film/gather_strip.glsl).
int sampleSlot(uvec3 xys) {
  const uint blocksPerRow = (pass.region.z + SLOT_COLUMNS - 1u) / SLOT_COLUMNS;
  const uint row = xys.z / GATHER_SAMPLES * pass.region.w + xys.y;
  const uint block = row * blocksPerRow + xys.x / SLOT_COLUMNS;
  return int(block * slotsPerBlock() + xys.z % GATHER_SAMPLES * SLOT_COLUMNS + xys.x % SLOT_COLUMNS);
}
