// Direct light of point lights: the sum, over the unoccluded lights, of irradiance times BSDF; the background
// where nothing is hit. In scenes with many lights it is called once for every few of them (pass.firstLight,
// pass.lightCount).
void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {
  if (HAS_BACKGROUND && pass.firstDispatch != 0u) {
    FOR_RAYS (uint r = 0u; r < R; ++r)
      if (hits.slot[r] == NO_HIT) radiance[r] = backgroundAt(rays.direction[r]);
  }
  if (!HAS_LIGHTS) return;
  Surface surfaces[R];
  Material materials[R];
  FOR_RAYS (uint r = 0u; r < R; ++r) {
    surfaces[r] = surfaceAt(rays.origin[r], rays.direction[r],
                            hits.slot[r] == NO_HIT ? 0u : hits.slot[r]);
    materials[r] = materialOf(surfaces[r]);
    surfaces[r].normal = bsdfNormal(surfaces[r]);
  }

  uint i = 0u;
  do {
    const uint number = pass.firstLight + i;
    const PointLight light = pointLightAt(number);
    vec3 points[R], irradiance[R];
    bool lit[R], clear[R];
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const Surface s = surfaces[r];
      const LightSample arriving = sampleLight(seenFrom(light, number, s.position), s);
      lit[r] = hits.slot[r] != NO_HIT && arriving.reaches &&
               dotProduct(s.normal, rays.direction[r]) < 0.0;
      irradiance[r] = arriving.irradiance;
      points[r] = offsetOrigin(s, arriving.direction);
    }
    if (HAS_SHAPED_LIGHTS) {
      Segments segments;
      FOR_RAYS (uint r = 0u; r < R; ++r) {
        const vec3 end = seenFrom(light, number, surfaces[r].position).position;
        segments.from[r] = points[r];
        segments.direction[r] = end - points[r];
        segments.isActive[r] = lit[r] && any(notEqual(segments.direction[r], vec3(0.0)));
      }
      unoccluded(segments, clear);
    } else {
      unoccludedToOne(light.position, points, lit, clear);
    }
    FOR_RAYS (uint r = 0u; r < R; ++r) {
      const Surface s = surfaces[r];
      if (clear[r])
        radiance[r] += evalBsdf(materials[r], s.normal, -rays.direction[r],
                                seenFrom(light, number, s.position).position - s.position,
                                irradiance[r]);
    }
  } while (++i < pass.lightCount);
}
