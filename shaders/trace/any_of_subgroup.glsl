// Whether any of the 8 lanes of a subgroup says so. Loops that call queries end for all of them together:
// queries are called in uniform control flow, without which lavapipe's lanes disturb each other.
bool anyOfSubgroup(bool x) {
  uint all = x ? 1u : 0u;
  [[unroll]] for (uint step = 1u; step < 8u; step *= 2u) all |= subgroupShuffleXor(all, step);
  return all != 0u;
}
