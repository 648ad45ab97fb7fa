// Surfaces with textures.
#include "trace/surface.glsl"

vec3 colourOf(Surface s) {
  const int texel = int(s.material * 4u);
  const uvec4 first = texelFetch(textureTexels, texel);
  const uvec4 second = texelFetch(textureTexels, texel + 1);
  const vec4 place = uintBitsToFloat(texelFetch(textureTexels, texel + 2));
  if (first.w == TEXTURE_NONE) return texelVec3(first);
  const uvec4 last = texelFetch(textureTexels, texel + 3);
  const TextureRecord t = TextureRecord(texelVec3(first), texelVec3(second),
                                        ImageRef(last.x, last.y, last.z, last.w));
  precise vec2 st = uvAt(3u * (s.id + second.w), s.weights) * place.xy + place.zw;
  return textureColour(first.w - 1u, t, st);
}
