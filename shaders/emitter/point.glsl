// Point lights: radiance / distance^2 arrives.
struct PointLight {
  vec3 position;
  vec3 radiance;
};

PointLight pointLightAt(uint number) {
  const int texel = int(number) * 2;
  return PointLight(texelVec3(texelFetch(lightTexels, texel)),
                    texelVec3(texelFetch(lightTexels, texel + 1)));
}

// Light from one emitter at a surface, if unoccluded.
struct LightSample {
  vec3 direction;   // to the emitter, not normalised
  vec3 irradiance;  // cosine included
  bool reaches;     // the emitter is above the surface
};

LightSample sampleLight(PointLight light, Surface s) {
  LightSample arriving;
  arriving.direction = light.position - s.position;
  const float squared = dotProduct(arriving.direction, arriving.direction);
  const float along = dotProduct(s.normal, arriving.direction);
  // A light nearer than 2^-50 of the scene, far below the rounding of positions, lies on the surface.
  arriving.reaches = along > 0.0 && squared > 7.8886091e-31;
  arriving.irradiance = light.radiance / squared * (along / sqrt(squared));
  return arriving;
}
