// Point lights: radiance / distance^2 arrives.
struct PointLight {
  vec3 position;
  vec3 radiance;
};

PointLight pointLightAt(uint number) {
  const int texel = int(number) * 3;
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
  arriving.reaches = along > 0.0 && squared > ON_SURFACE;
  arriving.irradiance = light.radiance / squared * (along / sqrt(squared));
  return arriving;
}
