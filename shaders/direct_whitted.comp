#version 460
#extension GL_GOOGLE_include_directive : require
#include "integrator.glsl"
#ifdef LAVER_TEXTURES
#include "background.glsl"
#endif

// Direct light of point lights on Lambertian surfaces: sum of radiance / distance^2 * cos * albedo
// / pi over the lights that the hit sees; where nothing is hit, the background.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
#ifdef LAVER_TEXTURES
  if (BACKGROUND != BACKGROUND_BLACK && pass.lights.z != 0u) {
    FOR_RAYS (uint r = 0u; r < R; ++r)
      if (hits.slot[r] == NO_HIT) radiance[r] = backgroundAt(rays.direction[r]);
  }
#endif
  if (LIGHTS == LIGHTS_NONE) return;
  Surface surfaces[R];
  FOR_RAYS (uint r = 0u; r < R; ++r)
    surfaces[r] =
        surfaceAt(rays.origin, rays.direction[r], hits.slot[r] == NO_HIT ? 0u : hits.slot[r]);

#ifdef LAVER_TEXTURES
  // A texture is looked up once, not for each light.
  vec3 albedo[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) albedo[r] = albedoOf(surfaces[r]);
#define ALBEDO(r) albedo[r]
#else
#define ALBEDO(r) albedoOf(surfaces[r])
#endif

  uint i = 0u;
  do {
    const int texel = int((pass.lights.x + i) * 2u);
    const vec3 light = texelVec3(texelFetch(lightTexels, texel));
    const vec3 power = texelVec3(texelFetch(lightTexels, texel + 1));
    vec3 points[R];
    bool lit[R], live[R], seen[R];
    float cosine[R], squared[R];
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const Surface s = surfaces[r];
      const vec3 toLight = light - s.position;
      squared[r] = dotProduct(toLight, toLight);
      const float along = dotProduct(s.normal, toLight);
      // Nearer than 2^-50 of the scene, far below the rounding of positions, is on the surface.
      lit[r] = hits.slot[r] != NO_HIT && along > 0.0 && squared[r] > 7.8886091e-31 &&
               dotProduct(s.normal, rays.direction[r]) < 0.0;
      live[r] = DARK_SIDES ? hits.slot[r] != NO_HIT : lit[r];
      cosine[r] = along / sqrt(squared[r]);
      points[r] = beside(s, toLight);
    }
    visible(light, points, live, seen);
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const vec3 irradiance = power / squared[r] * cosine[r];
      if (seen[r] && (lit[r] || !DARK_SIDES)) radiance[r] += irradiance * ALBEDO(r) * 0.31830989;
    }
  } while (++i < pass.lights.y);
}
