// Fresnel reflectance of unpolarised light at a smooth boundary.

// Of a dielectric (Born and Wolf, "Principles of Optics", 1.5). `eta` is the index on the side of the ray
// over that on the other, c1 and c2 are the cosines there, 0 <= c2.
float fresnelOf(float eta, float c1, float c2) {
  const float parallel = (eta * c2 - c1) / (eta * c2 + c1);
  const float perpendicular = (eta * c1 - c2) / (eta * c1 + c2);
  return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

// The same by a cosine in [0, 1] and the indices on the ray's side and on the other.
float dielectricFresnel(float cosine, float here, float beyond) {
  if (here == beyond) return 0.0;
  const float eta = here / beyond;
  const float c2Squared = 1.0 - eta * eta * (1.0 - cosine * cosine);
  return c2Squared < 0.0 ? 1.0 : fresnelOf(eta, cosine, sqrt(c2Squared));
}

// Of a conductor of the complex index eta + i k, for eta^2 + k^2 much larger than 1.
vec3 conductorFresnel(float cosine, vec3 eta, vec3 k) {
  const vec3 t = eta * eta + k * k;
  const vec3 twice = eta * (2.0 * cosine);
  const float c2 = cosine * cosine;
  const vec3 parallel = (t * c2 - twice + 1.0) / (t * c2 + twice + 1.0);
  const vec3 perpendicular = (t - twice + c2) / (t + twice + c2);
  return (parallel + perpendicular) * 0.5;
}
