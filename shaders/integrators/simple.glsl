// Direct light of the integrator's own point light on white surfaces: energy / (4 pi^2) * cos / distance^2.
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  const vec3 light = xml_position;
  vec3 points[R], arriving[R];
  bool lit[R], clear[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    const bool hit = hits.slot[r] != NO_HIT;
    const Surface s = surfaceAt(rays.origin[r], rays.direction[r], hit ? hits.slot[r] : 0u);
    const vec3 away = light - s.position;
    const float squared = dotProduct(away, away), along = dotProduct(s.normal, away);
    lit[r] = hit && along > 0.0 && squared > ON_SURFACE;
    arriving[r] = xml_energy * 0.0253302959 / squared * (along / sqrt(squared));
    points[r] = offsetOrigin(s, away);
  }
  unoccludedToOne(light, points, lit, clear);
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    if (clear[r]) radiance[r] += arriving[r];
  }
}
