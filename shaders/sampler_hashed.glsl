// The samplers `stratified` and `sobol`. Each pixel has its own hash; only parameters
// are read.
#ifndef LAVER_SAMPLER_HASHED
#define LAVER_SAMPLER_HASHED
#include "resources.glsl"

// Jarzynski and Olano's pcg3d ("Hash Functions for GPU Rendering", JCGT 9(3), 2020). Its low bits,
// which scramble() hands to the first digits, show the neighbours of a pixel; the last step hides
// them behind the high ones.
uvec3 hashOf(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v ^ v >> 16u;
}

// Nested uniform scrambling (Owen 1995) of a fraction whose bits stand in reverse: every bit is
// flipped or not by the seed and the bits below it. Laine and Karras' form (2011; Burley, JCGT
// 9(4), 2020) with Vegdahl's constants ("Building a Better LK Hash", 2021), which keep two samples
// as independent as exact scrambling does; with the constants of 2020 their bits hang together.
uint scramble(uint x, uint seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= seed >> 16 | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// Second coordinate of Sobol's sequence (1967), bits in reverse. Bit i is the parity of the bits j
// of the number where C(j, i) is odd, which is where j has all bits of i (Lucas).
uint sobolSecond(uint number) {
  number ^= number >> 1 & 0x55555555u;
  number ^= number >> 2 & 0x33333333u;
  number ^= number >> 4 & 0x0f0f0f0fu;
  number ^= number >> 8 & 0x00ff00ffu;
  return number ^ number >> 16;
}

// Any 2^k numbers from a multiple of 2^k on lie one in each rectangle of 2^-i by 2^(i-k). The first
// coordinate of the sequence, bits in reverse, is the number itself.
uvec2 sobolFraction(uvec3 hash, uint number) {
  return bitfieldReverse(uvec2(scramble(number, hash.x), scramble(sobolSecond(number), hash.y)));
}

uvec2 highProduct(uvec2 a, uvec2 b) {
  uvec2 high, low;
  umulExtended(a, b, high, low);
  return high;
}

// One sample in each of columns x rows strata. A pixel begins with a stratum of its own, so that
// what an early end leaves is no picture of one edge of the pixels.
uvec2 stratifiedFraction(uvec3 hash, uint number) {
  const uint count = params.film.z, rows = params.samplerArgs.x;
  const uvec2 size = params.samplerArgs.yz;  // of a stratum; 0 stands for 2^32
  const uvec2 first = highProduct(uvec2(hash.z), uvec2(count));
  const uint left = count - first.x;
  const uint stratum = number < left ? first.x + number : number - left;
  // stratum / rows by the reciprocal, which is too small by 1 at most.
  uint column = highProduct(uvec2(stratum), size).y;
  const uint over = stratum - column * rows >= rows ? 1u : 0u;
  column += over;
  const uvec2 place = uvec2(column, stratum - column * rows);
  const uvec2 random = hashOf(uvec3(hash.xy, number)).xy;
  return place * size + mix(highProduct(random, size), random, equal(size, uvec2(0u)));
}

// Samples lie at the middles of the cells of a grid so fine that pixel + jitter is exact: none is
// moved out of its pixel or stratum, and no two pixels' filters count one on their border.
uvec2 hashedFraction(uvec2 pixel, uint number) {
  const uvec3 hash = hashOf(uvec3(pixel, params.seed.z));
  uvec2 fraction;
  if (SAMPLER == SAMPLER_SOBOL)
    fraction = sobolFraction(hash, number);
  else
    fraction = stratifiedFraction(hash, number);
  const uint middle = params.seed.w;  // half a cell
  return fraction & -(middle << 1) | middle;
}

// Two more numbers of a sample, free of its place: `sobol` takes its sequence in another order,
// shuffled as scramble() does (Burley 2020, section 5), so that 2^k samples from a multiple of 2^k
// on have the same strata here; `stratified` draws them at random.
uvec2 hashedAperture(uvec2 pixel, uint number) {
  const uvec3 hash = hashOf(uvec3(pixel, ~params.seed.z));
  if (SAMPLER == SAMPLER_SOBOL)
    return sobolFraction(hash, bitfieldReverse(scramble(bitfieldReverse(number), hash.z)));
  return hashOf(uvec3(hash.xy, number)).xy;
}

#endif
