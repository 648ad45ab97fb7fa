// Grey noise: nine octaves of values at the corners of squares, each twice as coarse and twice as strong as the
// one before.

// A number in [0, 1) of each corner; integer hash by Jarzynski and Olano ("Hash Functions for GPU Rendering",
// 2020, pcg2d).
float noiseAt(ivec2 corner) {
  uvec2 v = uvec2(corner) * 1664525u + 1013904223u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  v.x += v.y * 1664525u;
  v.y += v.x * 1664525u;
  v ^= v >> 16u;
  return float(v.x >> 8) * 5.9604645e-8;
}

float smoothNoise(vec2 st) {
  const vec2 below = floor(st), part = st - below;
  const vec2 weight = part * part * (3.0 - 2.0 * part);
  const ivec2 corner = ivec2(below);
  return mix(mix(noiseAt(corner), noiseAt(corner + ivec2(1, 0)), weight.x),
             mix(noiseAt(corner + ivec2(0, 1)), noiseAt(corner + ivec2(1, 1)), weight.x), weight.y);
}

vec3 noiseTexture(TextureRecord t, vec2 st) {
  float sum = 0.0, strength = 1.0;
  [[dont_unroll]] for (uint octave = 0u; octave < 9u; ++octave) {
    sum += strength * smoothNoise(st / strength);
    strength *= 2.0;
  }
  return vec3(sum / 511.0);
}
