// The sampler `sobol`: a (0,2)-sequence, scrambled per pixel; further dimensions are padded with shuffled
// copies of the pair.
#include "sampler/hash.glsl"

// Nested uniform scrambling (Owen 1995) of a fraction in reversed bit order: the seed and the lower bits
// decide whether each bit is flipped. Laine and Karras' form (2011; Burley, JCGT 9(4), 2020) with Vegdahl's
// constants ("Building a Better LK Hash", 2021), which make two samples as independent as exact scrambling
// does; the constants of 2020 leave correlations.
uint scramble(uint x, uint seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= seed >> 16 | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// Second coordinate of Sobol's sequence (1967), bits reversed. Bit i is the parity of those bits j of the
// number for which C(j, i) is odd, that is, j has all bits of i (Lucas).
uint sobolSecond(uint number) {
  number ^= number >> 1 & 0x55555555u;
  number ^= number >> 2 & 0x33333333u;
  number ^= number >> 4 & 0x0f0f0f0fu;
  number ^= number >> 8 & 0x00ff00ffu;
  return number ^ number >> 16;
}

// Of any 2^k consecutive numbers that start at a multiple of 2^k, one lies in each rectangle of 2^-i by
// 2^(i-k). The first coordinate of the sequence, bits reversed, is the number itself.
uvec2 sobolFraction(uvec3 hash, uint number) {
  return bitfieldReverse(uvec2(scramble(number, hash.x), scramble(sobolSecond(number), hash.y)));
}

// Each dimension after the first takes the sequence in its own order, a nested uniform shuffle (Burley 2020,
// section 5): 2^k samples that start at a multiple of 2^k stay stratified.
uvec2 pairBits(uvec2 pixel, uint number, uint dimension) {
  if (dimension == 0u) {
    const uvec3 hash = hashOf(uvec3(pixel, params.seedHash));
    return cellMiddle(sobolFraction(hash, number));
  }
  const uvec3 hash = hashOf(uvec3(pixel, ~params.seedHash ^ (dimension - 1u) * 0x9e3779b9u));
  return sobolFraction(hash, bitfieldReverse(scramble(bitfieldReverse(number), hash.z)));
}
