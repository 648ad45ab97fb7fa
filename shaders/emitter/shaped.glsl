// Spot and directional lights as the point lights that a position sees in their place: a spot with the share of its
// intensity that goes there, a directional light from the far end of a line through the scene.
#include "texture/angle.glsl"

// The share of a spot light's intensity in a direction from it, of any length.
float spotShare(uvec4 first, uvec4 second, uvec4 third, vec3 away) {
  const vec3 axis = texelVec3(third);
  const uint shape = third.w;
  const vec3 unit = unitOr(away, axis);
  const float cosine = dotProduct(axis, unit);
  const vec3 across = crossProduct(axis, unit);
  const float angle = turnOf(sqrt(dotProduct(across, across)), cosine);
  const float from = (shape == LIGHT_SPOT_ANGLE ? -angle : cosine) - uintBitsToFloat(first.w);
  const float share = lesser(greater(from * uintBitsToFloat(second.w), 0.0), 1.0);
  if (shape == LIGHT_SPOT_ANGLE) return share;
  const float square = share * share;
  if (shape == LIGHT_SPOT_SQUARE) return square;
  return square * square * (shape == LIGHT_SPOT_PROJECTED ? greater(cosine, 0.0) : 1.0);
}

// The point light in place of light `number` of the list, which `light` was read from.
PointLight seenFrom(PointLight light, uint number, vec3 position) {
  if (!HAS_SHAPED_LIGHTS) return light;
  const int texel = int(number) * 3;
  const uvec4 third = texelFetch(lightTexels, texel + 2);
  const vec3 away = position - light.position;
  if (third.w == LIGHT_DIRECTIONAL) {
    const vec3 travelled = texelVec3(third) * params.sceneReach;
    light.position = position - travelled;
    light.radiance *= dotProduct(travelled, travelled);
  } else if (third.w != LIGHT_POINT) {
    light.radiance *=
        spotShare(texelFetch(lightTexels, texel), texelFetch(lightTexels, texel + 1), third, away);
  }
  return light;
}
