// Nori's `independent` sampler: one PCG32 stream (O'Neill, "PCG: A Family of ... Generators",
// HMC-CS-2014-0905) for each 32 x 32 block of the film, entered anywhere by tables of jumps.
#ifndef LAVER_SAMPLER
#define LAVER_SAMPLER
#include "resources.glsl"

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

float unitFloat(uint bits) { return uintBitsToFloat(bits >> 9 | 0x3f800000u) - 1.0; }

uvec2 jump(uvec2 state, uvec2 inc, uint entry) {
  const uvec4 t = texelFetch(jumpTexels, int(entry));
  return add64(mul64(t.xy, state), mul64(t.zw, inc));
}

// A generator before its next number.
struct Stream {
  uvec2 state, inc;
};

// The next two numbers. Nori built with gcc draws y first.
vec2 nextPair(inout Stream s) {
  const float y = unitFloat(pcgOutput(s.state));
  s.state = add64(mul64(s.state, PCG_MULTIPLIER), s.inc);
  const float x = unitFloat(pcgOutput(s.state));
  s.state = add64(mul64(s.state, PCG_MULTIPLIER), s.inc);
  return vec2(x, y);
}

// Where the numbers of a sample begin.
Stream streamAt(uvec2 pixel, uint number) {
  const uvec2 block = pixel & ~31u;
  const uvec2 inside = pixel & 31u;
  const uint blockWidth = min(32u, params.film.x - block.x);
  const uvec2 first = add64(params.seed.xy, uvec2(block.x, 0u));
  const uvec2 sequence = add64(params.seed.xy, uvec2(block.y, 0u));
  const uvec2 inc = uvec2(sequence.x << 1 | 1u, sequence.y << 1 | sequence.x >> 31);
  // Seeding ends one step beyond inc + first; the first table jumps that step too.
  uvec2 state = jump(add64(inc, first), inc, inside.y * blockWidth + inside.x);
  if (JUMP_LEVELS == 2) {
    state = jump(state, inc, params.jumps.x + number);
  } else if (JUMP_LEVELS == 3) {
    state = jump(state, inc, params.jumps.x + number % params.jumps.z);
    state = jump(state, inc, params.jumps.y + number / params.jumps.z);
  }
  return Stream(state, inc);
}

// Film position of a sample in pixels: the float sum of pixel and jitter, as Nori has it. Precise,
// or a compiler turns (pixel + jitter) - pixel back into jitter.
vec2 filmPosition(uvec2 pixel, uint number) {
  Stream s = streamAt(pixel, number);
  precise vec2 film = vec2(pixel) + nextPair(s);
  return film;
}

// The two numbers after these, which Nori draws for the aperture. A pinhole does not use them, so
// that they are free to choose a direction.
vec2 aperturePosition(uvec2 pixel, uint number) {
  Stream s = streamAt(pixel, number);
  nextPair(s);
  return nextPair(s);
}

#endif
