// Intersection methods that `laver chart` compares: one walk, one ray per invocation, with a choice of
// triangle test (TRIANGLES), box test (BOXES) and node format (QUANTISED). laver itself renders with
// TRIANGLES_OURS and BOXES_OURS.
#include "shared/charted.h"
#include "shared/layout.h"
#include "shared/point.h"
#include "charted/boxes.glsl"
#include "charted/triangles.glsl"

#include "trace/lane_stack.glsl"

layout(local_size_x = 64) in;
layout(binding = CHARTED_RAYS) uniform utextureBuffer rayTexels;
layout(binding = CHARTED_NODES) uniform utextureBuffer nodeTexels;
layout(binding = CHARTED_TRIANGLES) uniform utextureBuffer triangleTexels;
layout(binding = CHARTED_HITS) writeonly buffer HitBlock { vec4 hitOf[]; };
layout(binding = CHARTED_IDS) writeonly buffer IdBlock { uint idOf[]; };
layout(push_constant) uniform CountBlock { uvec4 count; };  // number of rays, reference of the root

vec3 texelVec3(uvec4 texel) { return uintBitsToFloat(texel.xyz); }

// Quantised node (after Ylitie, Karras and Laine, "Efficient Incoherent Ray Traversal on GPUs Through
// Compressed Wide BVHs", 2017): one texel with the origin and three exponents of 8 bits, then one texel per
// child: lo and hi in steps of 2^exponent from the origin, 8 bits per axis; the reference.
vec3 steps(uint packed) { return vec3(packed & 255u, packed >> 8 & 255u, packed >> 16 & 255u); }

uint enterNode(WalkRay ray, uint node, float last) {
  const int first = int(node * (QUANTISED ? NODE_WIDTH + 1u : NODE_WIDTH * 2u));
  uvec4 head = uvec4(0u);
  vec3 size = vec3(0.0);
  if (QUANTISED) {
    head = texelFetch(nodeTexels, first);
    size = uintBitsToFloat(uvec3(head.w << 23, head.w >> 8 << 23, head.w >> 16 << 23) & 0x7f800000u);
  }
  Children children;
  children.hit = 0u;
  [[unroll]] for (uint i = 0u; i < NODE_WIDTH; ++i) {
    const uint child = i ^ ray.octant;
    vec3 lo, hi;
    uint ref;
    if (QUANTISED) {
      const uvec4 packed = texelFetch(nodeTexels, first + 1 + int(child));
      precise vec3 low = texelVec3(head) + steps(packed.x) * size;
      precise vec3 high = texelVec3(head) + steps(packed.y) * size;
      lo = low;
      hi = high;
      ref = packed.z;
    } else {
      const uvec4 low = texelFetch(nodeTexels, first + int(child) * 2);
      lo = texelVec3(low);
      hi = texelVec3(texelFetch(nodeTexels, first + int(child) * 2 + 1));
      ref = low.w;
    }
    const BoxSpan span = boxOf(ray, lo, hi);
    const bool hit = span.near <= span.far && span.depth <= last && ref != REF_NONE;
    children.hit |= hit ? 1u << i : 0u;
    children.ref[i] = ref;
    children.depth[i] = span.depth;
  }
  return enter(children, last);
}

void main() {
  const uint number = gl_GlobalInvocationID.x;
  const bool isActive = number < count.x;
  const int texel = int(isActive ? number : 0u) * 2;
  const uvec4 start = texelFetch(rayTexels, texel), end = texelFetch(rayTexels, texel + 1);
  const vec3 origin = texelVec3(start), direction = texelVec3(end);
  const WalkRay ray = walkRay(origin, direction, uintBitsToFloat(start.w));
  // Depths are measured along the largest component of the direction, as in triangle.h.
  float last = uintBitsToFloat(end.w) * ray.scale;
  uint best = NO_HIT, bestId = NO_HIT;
  uint ref = count.y;
  stacked = 0u;
  do {
    do ref = enterNode(ray, ref, last); while (ref < REF_LEAF);
    do {
      uint slot = slotOf(ref), more;
      do {
        const uvec4 a = texelFetch(triangleTexels, int(slot) * 3);
        const uvec4 b = texelFetch(triangleTexels, int(slot) * 3 + 1);
        const uvec4 c = texelFetch(triangleTexels, int(slot) * 3 + 2);
        const TriangleHit hit =
            triangleHit(ray.shear, origin, direction, texelVec3(a), texelVec3(b), texelVec3(c));
        if (hit.inside && hit.depth >= ray.first && hit.depth <= last &&
            (hit.depth < last || a.w < bestId)) {
          last = hit.depth;
          best = slot;
          bestId = a.w;
        }
        more = b.w;
        slot++;
      } while (more > 0u);
      ref = pop(last);
    } while (ref >= REF_LEAF && ref != REF_NONE);
  } while (ref != REF_NONE);
  if (!isActive) return;
  vec4 result = vec4(0.0, 0.0, 0.0, last / ray.scale);
  if (best != NO_HIT) {
    const vec3 a = texelVec3(texelFetch(triangleTexels, int(best) * 3));
    const vec3 b = texelVec3(texelFetch(triangleTexels, int(best) * 3 + 1));
    const vec3 c = texelVec3(texelFetch(triangleTexels, int(best) * 3 + 2));
    if (TRIANGLES == TRIANGLES_OURS) {
      const Point p = pointAt(origin, direction, a, b, c, false);
      result = vec4(p.geometric, p.t);
    } else {
      result.xyz = normalize(cross(b - a, c - a));
    }
  }
  hitOf[number] = result;
  idOf[number] = bestId;
}
