#include "bench/embree_sampler.h"

namespace laver::bench {
namespace {

using Word = std::uint32_t;

Word highProduct(Word a, Word b) { return static_cast<Word>(std::uint64_t{a} * b >> 32); }

Word reversed(Word x) {
  x = (x >> 1 & 0x55555555U) | (x & 0x55555555U) << 1;
  x = (x >> 2 & 0x33333333U) | (x & 0x33333333U) << 2;
  x = (x >> 4 & 0x0f0f0f0fU) | (x & 0x0f0f0f0fU) << 4;
  x = (x >> 8 & 0x00ff00ffU) | (x & 0x00ff00ffU) << 8;
  return x >> 16 | x << 16;
}

/// pcg3d of Jarzynski and Olano, and its step of shifts once more.
void hash(Word& x, Word& y, Word& z) {
  x = x * 1664525U + 1013904223U;
  y = y * 1664525U + 1013904223U;
  z = z * 1664525U + 1013904223U;
  for (int round = 0; round < 2; ++round) {
    x += y * z;
    y += z * x;
    z += x * y;
    x ^= x >> 16;
    y ^= y >> 16;
    z ^= z >> 16;
  }
}

/// Owen scrambling with the bits in reverse, by Vegdahl's constants.
Word scrambled(Word x, Word seed) {
  x ^= x * 0x3d20adeaU;
  x = (x + seed) * (seed >> 16 | 1U);
  x ^= x * 0x05526c56U;
  return x ^ x * 0x53a22864U;
}

/// Sobol's second dimension, bits in reverse.
Word sobolSecond(Word n) {
  n ^= n >> 1 & 0x55555555U;
  n ^= n >> 2 & 0x33333333U;
  n ^= n >> 4 & 0x0f0f0f0fU;
  n ^= n >> 8 & 0x00ff00ffU;
  return n ^ n >> 16;
}

/// To the middles of the cells of the grid.
void toMiddles(const shared::Params& params, Places& p) {
  const Word middle = params.seed.w;
  for (int i = 0; i < 16; ++i) {
    p.x[i] = (p.x[i] & ~(2 * middle - 1)) | middle;
    p.y[i] = (p.y[i] & ~(2 * middle - 1)) | middle;
  }
}

}  // namespace

void placeSobol(const shared::Params& params, Places& p) {
  for (int i = 0; i < 16; ++i) {
    Word x = p.pixelX[i], y = p.pixelY[i], z = params.seed.z;
    hash(x, y, z);
    p.x[i] = reversed(scrambled(p.number[i], x));
    p.y[i] = reversed(scrambled(sobolSecond(p.number[i]), y));
  }
  toMiddles(params, p);
}

void placeStratified(const shared::Params& params, Places& p) {
  const Word count = params.film.z, rows = params.samplerArgs.x;
  const Word width = params.samplerArgs.y, height = params.samplerArgs.z;  // 0 stands for 2^32
  for (int i = 0; i < 16; ++i) {
    Word x = p.pixelX[i], y = p.pixelY[i], z = params.seed.z;
    hash(x, y, z);
    const Word first = highProduct(z, count), left = count - first, n = p.number[i];
    const Word stratum = n < left ? first + n : n - left;
    // stratum / rows by the reciprocal, which is too small by 1 at most.
    Word column = highProduct(stratum, height);
    column += stratum - column * rows >= rows ? 1U : 0U;
    Word u = x, v = y, w = n;
    hash(u, v, w);
    p.x[i] = column * width + (width == 0 ? u : highProduct(u, width));
    p.y[i] = (stratum - column * rows) * height + (height == 0 ? v : highProduct(v, height));
  }
  toMiddles(params, p);
}

}  // namespace laver::bench
