// The random numbers of a sample: a stream of pairs, indexed by (pixel, sample, dimension). Dimension 0 is the
// position on the film, dimension 1 the pair that Nori draws for the aperture. The sampler of the kernel
// defines pairBits(), the pair as fractions in units of 2^-32.

float unitFloat(uint bits) { return uintBitsToFloat(bits >> 9 | 0x3f800000u) - 1.0; }

// In [0, 1)^2.
vec2 samplePair(uvec2 pixel, uint number, uint dimension) {
  const uvec2 bits = pairBits(pixel, number, dimension);
  return vec2(unitFloat(bits.x), unitFloat(bits.y));
}

// Film position of a sample in pixels: the float sum of pixel and jitter, as in Nori. Precise here and in
// insidePixel(), since a compiler may simplify (pixel + jitter) - pixel to jitter.
vec2 filmPosition(uvec2 pixel, uint number) {
  const uvec2 bits = pairBits(pixel, number, 0u);
  precise vec2 film = vec2(pixel) + vec2(unitFloat(bits.x), unitFloat(bits.y));
  return film;
}

// The part of a film position inside its pixel.
vec2 insidePixel(vec2 film, uvec2 pixel) {
  precise vec2 inside = film - vec2(pixel);
  return inside;
}
