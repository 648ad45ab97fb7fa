// Arrays of texels as texel buffers, which most drivers read fastest. They are bound without samplers, since
// SPIR-V 1.6 forbids sampled images of dimension Buffer.
#define TEXELS(slot, name) layout(binding = slot) uniform utextureBuffer name
#define FLOAT_TEXELS(slot, name) layout(binding = slot) uniform textureBuffer name

// DO(condition) { … } WHILE(condition); where the condition is true at first: a loop that reads texels, in the form
// that the driver takes best. lavapipe runs one extra, fully masked iteration of a loop that tests first.
#define DO(condition) do
#define WHILE(condition) while (condition)
