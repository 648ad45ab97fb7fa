// A vec4 as kernels store it: lavapipe stores number by number and lane by lane, so that two 64-bit
// numbers take less time than four floats.
#define Stored u64vec2
Stored stored(vec4 v) {
  const uvec4 bits = floatBitsToUint(v);
  return Stored(packUint2x32(bits.xy), packUint2x32(bits.zw));
}
