// Caps (shared/cap.h) are stored outside of the tree: every ray is tested against all of them.
#include "resources.glsl"
#include "shared/cap.h"

Cap capAt(uint number, out uint id) {
  const int texel = int((params.firstCap + number) * 3u);
  const uvec4 first = texelFetch(triangleTexels, texel);
  id = first.w;
  return capOf(texelVec3(first), texelVec3(texelFetch(triangleTexels, texel + 1)),
               texelVec3(texelFetch(triangleTexels, texel + 2)));
}

// Updates the nearest hit of a ray from depth `first` on; `scale` is the depth of its direction.
void meetCaps(vec3 origin, vec3 direction, float scale, float first, inout float last,
              inout uint best, inout uint bestId) {
  for (uint i = 0u; i < params.capCount; ++i) {
    uint id;
    const Cap cap = capAt(i, id);
    const CapCrossings at = crossingsOf(cap, origin - cap.nearest, direction);
    precise float near = at.first * scale, far = at.second * scale;
    float depth = near >= first ? near : far;
    bool hit = at.hit;
    if (BOUNCES && first == 0.0) {
      // A ray that starts on a surface, as for spheres of the tree.
      const bool startsOutside = heightOver(cap, origin - cap.nearest) > 0.0;
      hit = at.hit && (!startsOutside || at.middle > 0.0);
      depth = greater(startsOutside ? near : far, 0.0);
    }
    if (hit && depth >= first && depth <= last && (depth < last || id < bestId)) {
      last = depth;
      best = params.firstCap + i;
      bestId = id;
    }
  }
}

bool capsBlock(vec3 from, vec3 end) {
  bool blocked = false;
  for (uint i = 0u; i < params.capCount; ++i) {
    uint id;
    blocked = capBlocks(capAt(i, id), from, end) || blocked;
  }
  return blocked;
}
