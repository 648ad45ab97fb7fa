// The input of a texture. A texture NAME, in texture/NAME.glsl, is one function:
//   vec3 NAMETexture(TextureRecord t, vec2 st)
// textureColour(), composed from the kernel's key, calls the right one.
#include "texture/image.glsl"

struct TextureRecord {
  vec3 color1, color2;
  ImageRef image;
};

vec2 uvAt(uint firstTexel, vec3 weights) {
  const int texel = int(firstTexel);
  const vec2 a = uintBitsToFloat(texelFetch(uvTexels, texel).xy);
  const vec2 b = uintBitsToFloat(texelFetch(uvTexels, texel + 1).xy);
  const vec2 c = uintBitsToFloat(texelFetch(uvTexels, texel + 2).xy);
  precise vec2 uv = a * weights.x + b * weights.y + c * weights.z;
  return uv;
}
