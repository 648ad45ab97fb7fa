// What a material shows at a hit.
#ifndef LAVER_TEXTURE
#define LAVER_TEXTURE
#include "picture.glsl"

// 0 or 1: whether the largest whole number below x is odd.
float oddness(float x) {
  const float whole = floor(x);
  return whole - 2.0 * floor(0.5 * whole);
}

vec2 uvAt(uint firstTexel, vec3 weights) {
  const int texel = int(firstTexel);
  const vec2 a = uintBitsToFloat(texelFetch(uvTexels, texel).xy);
  const vec2 b = uintBitsToFloat(texelFetch(uvTexels, texel + 1).xy);
  const vec2 c = uintBitsToFloat(texelFetch(uvTexels, texel + 2).xy);
  precise vec2 uv = a * weights.x + b * weights.y + c * weights.z;
  return uv;
}

vec3 textureAt(uint material, uint id, vec3 weights) {
  const int texel = int(material * 4u);
  const uvec4 first = texelFetch(textureTexels, texel);
  const uvec4 second = texelFetch(textureTexels, texel + 1);
  const vec4 place = uintBitsToFloat(texelFetch(textureTexels, texel + 2));
  vec3 color = texelVec3(first);
  if (first.w != TEXTURE_NONE) {
    precise vec2 st = uvAt(3u * (id + second.w), weights) * place.xy + place.zw;
    if ((TEXTURES & TEXTURES_CHECKER) != 0u && first.w == TEXTURE_CHECKER)
      color = oddness(st.x) == oddness(st.y) ? color : texelVec3(second);
    if ((TEXTURES & TEXTURES_IMAGE) != 0u && first.w == TEXTURE_IMAGE) {
      const uvec4 last = texelFetch(textureTexels, texel + 3);
      const Picture picture = Picture(last.x, last.y, last.z, last.w);
      color *= pictureAt(picture, unitPart(st.x), 1.0 - unitPart(st.y), true);
    }
  }
  return color;
}

#endif
