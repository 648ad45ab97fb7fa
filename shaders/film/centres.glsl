// In place of an integrator: writes the hit of the ray through each pixel's centre to the film, encoded as
// FilmPixel describes. The samples that main() stores are not read.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const uvec2 place = rayPlace(tileOrigin(), r).xy;
    const bool hit = hits.slot[r] != NO_HIT;
    const vec3 d = rays.direction[r];
    uint id;
    const Point p = hitPointAt(rays.origin[r], d, rays.tmin[r], hit ? hits.slot[r] : 0u, id);
    const float distance = cameraDistance(p.t, d);
    if (rays.isActive[r])
      filmPixels[place.y * pass.region.z + place.x] =
          FilmPixel(vec4(p.position, hit ? distance : 0.0),
                    vec4(p.weights.yz, float(id & 0xffffu), float(id >> 16)));
  }
}
