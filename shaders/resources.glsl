// What the kernels read and write.
#ifndef LAVER_RESOURCES
#define LAVER_RESOURCES
#include "shared/layout.h"

layout(constant_id = SPEC_STACK) const uint STACK = 64;
layout(constant_id = SPEC_NORMALS) const bool HAS_NORMALS = true;
layout(constant_id = SPEC_ALBEDOS) const bool HAS_ALBEDOS = true;
layout(constant_id = SPEC_LIGHTS) const bool HAS_LIGHTS = true;
layout(constant_id = SPEC_JUMP_LEVELS) const uint JUMP_LEVELS = 3;
layout(constant_id = SPEC_FILTER) const uint FILTER = FILTER_GAUSSIAN;
layout(constant_id = SPEC_APRON) const uint APRON = 2;
layout(constant_id = SPEC_NORI_TABLE) const bool NORI_TABLE = false;

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
layout(binding = BIND_RADIANCE) buffer RadianceBlock { vec4 radianceOf[]; };
layout(binding = BIND_WEIGHTS) buffer WeightsBlock { float weightOf[]; };
layout(binding = BIND_FILM) buffer FilmBlock { FilmPixel filmPixels[]; };
layout(binding = BIND_STATUS) buffer StatusBlock { Status status; };
layout(binding = BIND_RADIANCE_TEXELS) uniform samplerBuffer radianceTexels;
layout(binding = BIND_WEIGHT_TEXELS) uniform samplerBuffer weightTexels;

vec3 texelVec3(uvec4 texel) { return uintBitsToFloat(texel.xyz); }

// Samples of a pass; sample s of region pixel (x, y) is number (s * height + y) * width + x.
uint samplesOfPass() { return pass.region.z * pass.region.w * pass.samples.y; }

#endif
