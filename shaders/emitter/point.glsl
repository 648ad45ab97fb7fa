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

// Light that arrives at a surface from one emitter, if nothing lies between.
struct LightSample {
  vec3 direction;   // to the emitter, of the distance's length
  vec3 irradiance;  // cosine included
  bool reaches;     // from the upper side
};

LightSample sampleLight(PointLight light, Surface s) {
  LightSample arriving;
  arriving.direction = light.position - s.position;
  const float squared = dotProduct(arriving.direction, arriving.direction);
  const float along = dotProduct(s.normal, arriving.direction);
  // Nearer than 2^-50 of the scene, far below the rounding of positions, is on the surface.
  arriving.reaches = along > 0.0 && squared > 7.8886091e-31;
  arriving.irradiance = light.radiance / squared * (along / sqrt(squared));
  return arriving;
}
