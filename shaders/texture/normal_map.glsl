// Normal maps: a texture's colour c is the normal 2c - 1 in the frame whose z is the shading normal n, whose x lies
// along u, and whose y is n x x.
#include "bsdf/frame.glsl"
#include "texture/along_u.glsl"
#include "texture/textured.glsl"

vec3 mappedNormal(Surface s, uint number) {
  const vec3 c = 2.0 * textureAt(number, s.id, s.weights) - 1.0;
  const vec3 n = s.normal;
  const vec3 x = frameX(n, alongU(s, 3u * (s.id + texelFetch(textureTexels, int(number * 4u) + 1).w)));
  return unitOr(x * c.x + crossProduct(n, x) * c.y + n * c.z, n);
}
