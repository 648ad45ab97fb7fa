// What a texture shows at a place of a surface.
#include "trace/surface.glsl"

// Of the primitive `id` with the weights of its corners.
vec3 textureAt(uint number, uint id, vec3 weights) {
  const int texel = int(number * 4u);
  const uvec4 first = texelFetch(textureTexels, texel);
  const uvec4 second = texelFetch(textureTexels, texel + 1);
  const vec4 place = uintBitsToFloat(texelFetch(textureTexels, texel + 2));
  const uvec4 last = texelFetch(textureTexels, texel + 3);
  const TextureRecord t = TextureRecord(texelVec3(first), texelVec3(second),
                                        ImageRef(last.x, last.y, last.z, last.w));
  precise vec2 st = uvAt(3u * (id + second.w), weights) * place.xy + place.zw;
  return textureColour(first.w, t, st);
}
