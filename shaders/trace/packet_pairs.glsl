// Distribution of tests among lanes. A pair is a lane, with its rays, and a triangle that those rays may hit.
// All pairs are numbered, lane by lane; lane k tests pairs k, k + 8 and so on.
#include "trace/frustum.glsl"

struct Pairs {
  // One byte for each of the four lanes of this half: bits of its triangles; their counts per half byte; and
  // the sums of the counts up to and including each byte.
  uint triangles, halves, upTo;
  uint firstFour;   // number of pairs of lanes 0 to 3
  uint total;
  uint begin, end;  // range of this lane's pairs
};

Pairs pairsOf(uint mine) {
  const uint shift = 8u * (lane() & 3u);
  Pairs p;
  p.triangles = mine << shift;
  p.triangles |= subgroupShuffleXor(p.triangles, 1u);
  p.triangles |= subgroupShuffleXor(p.triangles, 2u);
  const uint twos = p.triangles - (p.triangles >> 1 & 0x55555555u);
  p.halves = (twos & 0x33333333u) + (twos >> 2 & 0x33333333u);
  p.upTo = ((p.halves + (p.halves >> 4)) & 0x0f0f0f0fu) * 0x01010101u;
  p.firstFour = subgroupShuffle(p.upTo, 0u) >> 24;
  p.total = p.firstFour + (subgroupShuffle(p.upTo, 4u) >> 24);
  const uint before = lane() < 4u ? 0u : p.firstFour;
  p.begin = before + (p.upTo << 8 >> shift & 0xffu);
  p.end = before + (p.upTo >> shift & 0xffu);
  return p;
}

// Pair `number` as 8 * lane + triangle: the position of a set bit, found by successive halving (Vigna,
// "Broadword Implementation of Rank/Select Queries", WEA 2008, finds the byte in the same way). Beyond the
// last pair any of the 64 positions: an unnecessary test does not change the result.
uint pairAt(Pairs p, uint number) {
  const uint fourth = number >= p.firstFour ? 4u : 0u;
  number -= fourth == 0u ? 0u : p.firstFour;
  const uint upTo = subgroupShuffle(p.upTo, fourth);
  // Bytes that end at or before `number`, times 8.
  const uint ended = ((number * 0x01010101u | 0x80808080u) - upTo) & 0x80808080u;
  const uint shift = (ended >> 4) * 0x01010101u >> 24 & 31u;
  number -= upTo << 8 >> shift & 0xffu;
  uint bits = subgroupShuffle(p.triangles, fourth) >> shift;
  uint place = 8u * fourth + shift;

  uint below = subgroupShuffle(p.halves, fourth) >> shift & 15u;
  bool above = number >= below;
  number -= above ? below : 0u;
  bits = above ? bits >> 4 : bits;
  place += above ? 4u : 0u;

  below = (bits & 1u) + (bits >> 1 & 1u);
  above = number >= below;
  number -= above ? below : 0u;
  bits = above ? bits >> 2 : bits;
  place += above ? 2u : 0u;
  return place + (number >= (bits & 1u) ? 1u : 0u);
}
