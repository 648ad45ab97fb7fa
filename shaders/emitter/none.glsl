// No background: black.
vec3 backgroundAt(vec3 direction) { return vec3(0.0); }

vec3 sampleBackground(Source source, vec2 numbers, out float density, out vec3 radiance) {
  density = 0.0;
  radiance = vec3(0.0);
  return vec3(0.0, 0.0, 1.0);
}

float backgroundDensity(vec3 direction) { return 0.0; }
