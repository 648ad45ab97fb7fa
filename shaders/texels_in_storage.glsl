// Arrays of texels as storage buffers, for devices whose texel buffers are small. Every texel has four words there
// (host/render/device_scene.cpp). An index beyond the end, such as that of a ray without a hit, reads the last texel.
#define TEXELS(slot, name) layout(binding = slot) readonly buffer name##Block { uvec4 name[]; }
#define FLOAT_TEXELS(slot, name) layout(binding = slot) readonly buffer name##Block { vec4 name[]; }
#define texelFetch(texels, index) texels[min(uint(index), uint(texels.length()) - 1u)]

// texel_buffers.glsl. SwiftShader keeps wrong values of lanes that left a `do … while` loop with such reads earlier
// than others: up to 11 % of the pixels of a picture showed farther surfaces.
#define DO(condition) while (condition)
#define WHILE(condition)
