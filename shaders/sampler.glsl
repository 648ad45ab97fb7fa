// Where the samples of a pixel lie. The sampler is a specialisation constant: a kernel holds one.
#ifndef LAVER_SAMPLER
#define LAVER_SAMPLER
#include "sampler_hashed.glsl"
#include "sampler_independent.glsl"

float unitFloat(uint bits) { return uintBitsToFloat(bits >> 9 | 0x3f800000u) - 1.0; }

// Film position of a sample in pixels: the float sum of pixel and jitter, as Nori has it. Precise,
// as insidePixel() is, or a compiler turns (pixel + jitter) - pixel back into jitter.
vec2 filmPosition(uvec2 pixel, uint number) {
  uvec2 fraction;  // of a pixel, in 2^-32
  if (SAMPLER == SAMPLER_INDEPENDENT)
    fraction = independentFraction(pixel, number, 0u);
  else
    fraction = hashedFraction(pixel, number);
  precise vec2 film = vec2(pixel) + vec2(unitFloat(fraction.x), unitFloat(fraction.y));
  return film;
}

// Where a film position lies in its pixel.
vec2 insidePixel(vec2 film, uvec2 pixel) {
  precise vec2 inside = film - vec2(pixel);
  return inside;
}

// Two more numbers in [0, 1), which Nori draws for the aperture. A pinhole does not use them, so that
// they are free to choose a direction.
vec2 aperturePosition(uvec2 pixel, uint number) {
  uvec2 fraction;
  if (SAMPLER == SAMPLER_INDEPENDENT)
    fraction = independentFraction(pixel, number, 1u);
  else
    fraction = hashedAperture(pixel, number);
  return vec2(unitFloat(fraction.x), unitFloat(fraction.y));
}

#endif
