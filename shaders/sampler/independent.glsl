// Nori's `independent` sampler: one PCG32 stream (O'Neill, "PCG: A Family of ... Generators",
// HMC-CS-2014-0905) per 32 x 32 block of the film. Tables of jumps enter a stream at any place.
#include "sampler/hash.glsl"

// 64-bit numbers are (low, high).
uvec2 add64(uvec2 a, uvec2 b) {
  uint carry;
  const uint low = uaddCarry(a.x, b.x, carry);
  return uvec2(low, a.y + b.y + carry);
}

uvec2 mul64(uvec2 a, uvec2 b) {
  uint high, low;
  umulExtended(a.x, b.x, high, low);
  return uvec2(low, high + a.x * b.y + a.y * b.x);
}

const uvec2 PCG_MULTIPLIER = uvec2(0x4c957f2du, 0x5851f42du);  // 6364136223846793005

uint pcgOutput(uvec2 state) {
  const uvec2 x = uvec2(state.x >> 18 | state.y << 14, state.y >> 18) ^ state;
  const uint word = x.x >> 27 | x.y << 5;
  const uint rotation = state.y >> 27;
  return word >> rotation | word << (-rotation & 31u);
}

uvec2 jump(uvec2 state, uvec2 inc, uint entry) {
  const uvec4 t = texelFetch(jumpTexels, int(entry));
  return add64(mul64(t.xy, state), mul64(t.zw, inc));
}

// Numbers 2 `pair` and 2 `pair` + 1 of the four that Nori draws per sample.
uvec2 streamPair(uvec2 pixel, uint number, uint pair) {
  const uvec2 block = pixel & ~31u;
  const uvec2 inside = pixel & 31u;
  const uint blockWidth = min(32u, params.filmSize.x - block.x);
  const uvec2 first = add64(params.seed, uvec2(block.x, 0u));
  const uvec2 sequence = add64(params.seed, uvec2(block.y, 0u));
  const uvec2 inc = uvec2(sequence.x << 1 | 1u, sequence.y << 1 | sequence.x >> 31);
  // Seeding leaves the state one step beyond inc + first; the jumps of the first table include that step.
  uvec2 state = jump(add64(inc, first), inc, inside.y * blockWidth + inside.x);
  if (JUMP_LEVELS == 2u) {
    state = jump(state, inc, params.samplerArguments.x + number);
  } else if (JUMP_LEVELS == 3u) {
    state = jump(state, inc, params.samplerArguments.x + number % params.samplerArguments.z);
    state = jump(state, inc, params.samplerArguments.y + number / params.samplerArguments.z);
  }
  for (uint i = 0u; i < 2u * pair; ++i) state = add64(mul64(state, PCG_MULTIPLIER), inc);
  const uint y = pcgOutput(state);  // Nori built with gcc draws y first
  state = add64(mul64(state, PCG_MULTIPLIER), inc);
  return uvec2(pcgOutput(state), y);
}

// Nori draws further numbers in an order that depends on the path's hits; here they are hashed.
uvec2 pairBits(uvec2 pixel, uint number, uint dimension) {
  return dimension < 2u ? streamPair(pixel, number, dimension)
                        : hashedPair(pixel, number, dimension);
}
