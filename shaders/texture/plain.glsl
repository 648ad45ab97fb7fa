// Surfaces without textures: the albedo of the material, or the one that all meshes share.
#include "trace/surface.glsl"

vec3 colourOf(Surface s) {
  if (!HAS_MATERIALS) return params.albedo;
  return texelVec3(texelFetch(materialTexels, int(s.material) * 2));
}
