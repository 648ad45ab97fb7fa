// One over the distance from the camera to the nearest hit, in scene units.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (hits.slot[r] == NO_HIT) continue;
    const vec3 d = rays.direction[r];
    const Surface s = surfaceAt(rays.origin[r], d, hits.slot[r]);
    radiance[r] = vec3(1.0 / cameraDistance(s.t, d));
  }
}
