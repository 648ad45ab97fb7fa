// Bindings: all buffers that kernels read and write. The constants of the kernel's key precede this text
// (host/kernels/compose.cpp).
#include "shared/layout.h"
#include "shared/slots.h"

const uint REACH = 2u * APRON + 1u;  // pixels on an axis that one sample reaches

layout(std140, binding = BIND_PARAMS) uniform ParamsBlock { Params params; };
layout(push_constant) uniform PassBlock { Pass pass; };

// Texels by index (texel_buffers.glsl or texels_in_storage.glsl, by the key). They are unsigned integers: floats
// keep their bits, denormals and NaN patterns included.
TEXELS(BIND_NODES, nodeTexels);
TEXELS(BIND_TRIANGLES, triangleTexels);
TEXELS(BIND_ATTRIBUTES, attributeTexels);
TEXELS(BIND_NORMALS, normalTexels);
TEXELS(BIND_MATERIALS, materialTexels);
TEXELS(BIND_LIGHTS, lightTexels);
TEXELS(BIND_JUMPS, jumpTexels);
layout(binding = BIND_SAMPLES) writeonly buffer SamplesBlock { Stored samples[]; };
layout(binding = BIND_SAMPLES_Y) writeonly buffer SamplesYBlock { float samplesY[]; };
layout(binding = BIND_FILM) buffer FilmBlock { FilmPixel filmPixels[]; };
layout(binding = BIND_STATUS) buffer StatusBlock {
  Status status;
  uint answers[];
};
FLOAT_TEXELS(BIND_SAMPLE_TEXELS, sampleTexels);
FLOAT_TEXELS(BIND_SAMPLE_Y_TEXELS, sampleYTexels);
TEXELS(BIND_COUNTS, countTexels);
TEXELS(BIND_WORK, workTexels);
TEXELS(BIND_TEXTURES, textureTexels);
TEXELS(BIND_UVS, uvTexels);
TEXELS(BIND_EMISSION, emissionTexels);
TEXELS(BIND_SOURCES, sourceTexels);
TEXELS(BIND_IMAGES, imageTexels);

vec3 texelVec3(uvec4 texel) { return uintBitsToFloat(texel.xyz); }

// Slot of a sample, by (x, y) in pixels of the region and its number in the pass.
int sampleSlot(uvec3 xys) {
  return int(slotOf(pass.sampleCount, pass.region, xys.x, xys.y, xys.z));
}
