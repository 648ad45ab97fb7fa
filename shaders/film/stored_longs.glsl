// The type in which kernels store a vec4: lavapipe stores component by component and lane by lane, so two
// 64-bit integers take less time than four floats.
#define Stored u64vec2
Stored stored(vec4 v) {
  const uvec4 bits = floatBitsToUint(v);
  return Stored(packUint2x32(bits.xy), packUint2x32(bits.zw));
}
