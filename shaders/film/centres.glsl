// In place of an integrator: writes the hit of the ray through each pixel's centre to the film, encoded as
// FilmPixel describes. The samples that main() stores are not read.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const uvec2 place = rayPlace(tileOrigin(), r).xy;
    const bool hit = hits.slot[r] != NO_HIT;
    const int texel = int(hit ? hits.slot[r] * 3u : 0u);
    const uvec4 a = texelFetch(triangleTexels, texel);
    const vec3 b = texelVec3(texelFetch(triangleTexels, texel + 1));
    const uvec4 c = texelFetch(triangleTexels, texel + 2);
    const vec3 d = rays.direction[r];
    Point p = pointAt(rays.origin[r], d, texelVec3(a), b, texelVec3(c), false);
    if (HAS_SPHERES) {
      if (c.w == IS_SPHERE) p = sphereHitAt(rays.origin[r], d, rays.tmin[r], texelVec3(a), b.x);
    }
    const float distance = sceneLength(p.t, d);
    if (rays.isActive[r])
      filmPixels[place.y * pass.region.z + place.x] =
          FilmPixel(vec4(p.position, hit ? distance : 0.0),
                    vec4(p.weights.yz, float(a.w & 0xffffu), float(a.w >> 16)));
  }
}
