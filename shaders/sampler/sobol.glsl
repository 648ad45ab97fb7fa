// The sampler `sobol`: a (0,2)-sequence, scrambled by pixel; further dimensions are padded by pairs.
#include "sampler/hash.glsl"

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

// Dimensions after the first take the sequence in an order of their own, shuffled as scramble() does
// (Burley 2020, section 5), so that 2^k samples from a multiple of 2^k on have the same strata there.
uvec2 pairBits(uvec2 pixel, uint number, uint dimension) {
  if (dimension == 0u) {
    const uvec3 hash = hashOf(uvec3(pixel, params.seedHash));
    return cellMiddle(sobolFraction(hash, number));
  }
  const uvec3 hash = hashOf(uvec3(pixel, ~params.seedHash ^ (dimension - 1u) * 0x9e3779b9u));
  return sobolFraction(hash, bitfieldReverse(scramble(bitfieldReverse(number), hash.z)));
}
