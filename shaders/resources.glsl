// Bindings: all buffers that kernels read and write. The constants of the kernel's key precede this text
// (host/kernels/compose.cpp).
#include "shared/layout.h"
#include "shared/slots.h"

const uint REACH = 2u * APRON + 1u;  // pixels on an axis that one sample reaches

layout(std140, binding = BIND_PARAMS) uniform ParamsBlock { Params params; };
layout(push_constant) uniform PassBlock { Pass pass; };

// Texel buffers are bound without samplers, since SPIR-V 1.6 forbids sampled images of dimension Buffer.
// Their type is uvec4: floats keep their bits, denormals and NaN patterns included.
layout(binding = BIND_NODES) uniform utextureBuffer nodeTexels;
layout(binding = BIND_TRIANGLES) uniform utextureBuffer triangleTexels;
layout(binding = BIND_ATTRIBUTES) uniform utextureBuffer attributeTexels;
layout(binding = BIND_NORMALS) uniform utextureBuffer normalTexels;
layout(binding = BIND_MATERIALS) uniform utextureBuffer materialTexels;
layout(binding = BIND_LIGHTS) uniform utextureBuffer lightTexels;
layout(binding = BIND_JUMPS) uniform utextureBuffer jumpTexels;
layout(binding = BIND_SAMPLES) writeonly buffer SamplesBlock { Stored samples[]; };
layout(binding = BIND_SAMPLES_Y) writeonly buffer SamplesYBlock { float samplesY[]; };
layout(binding = BIND_FILM) buffer FilmBlock { FilmPixel filmPixels[]; };
layout(binding = BIND_STATUS) buffer StatusBlock {
  Status status;
  uint answers[];
};
layout(binding = BIND_SAMPLE_TEXELS) uniform textureBuffer sampleTexels;
layout(binding = BIND_SAMPLE_Y_TEXELS) uniform textureBuffer sampleYTexels;
layout(binding = BIND_COUNTS) uniform utextureBuffer countTexels;
layout(binding = BIND_WORK) uniform utextureBuffer workTexels;
layout(binding = BIND_TEXTURES) uniform utextureBuffer textureTexels;
layout(binding = BIND_UVS) uniform utextureBuffer uvTexels;
layout(binding = BIND_EMISSION) uniform utextureBuffer emissionTexels;
layout(binding = BIND_SOURCES) uniform utextureBuffer sourceTexels;
layout(binding = BIND_IMAGES) uniform utextureBuffer imageTexels;

vec3 texelVec3(uvec4 texel) { return uintBitsToFloat(texel.xyz); }

// Slot of a sample, by (x, y) in pixels of the region and its number in the pass.
int sampleSlot(uvec3 xys) {
  return int(slotOf(pass.sampleCount, pass.region, xys.x, xys.y, xys.z));
}
