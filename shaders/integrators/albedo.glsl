// The surface's albedo; black where nothing is hit.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (hits.slot[r] == NO_HIT) continue;
    radiance[r] =
        materialOf(surfaceAt(rays.origin[r], rays.direction[r], hits.slot[r])).albedo;
  }
}
