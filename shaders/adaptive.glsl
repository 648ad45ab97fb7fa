// Adaptive sampling: cells of pixels have sample counts of their own, and workgroups take their work
// from a list.
#ifndef LAVER_ADAPTIVE
#define LAVER_ADAPTIVE
#include "resources.glsl"

#extension GL_EXT_control_flow_attributes : require

// This workgroup's work; the list is cut into rows of workgroups.
uvec3 listedWork() {
  const uint number = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
  return texelFetch(workTexels, int(pass.tiles.w + number)).xyz;
}

// Samples of a pixel of the region.
uint countAt(uvec2 place) {
  const uvec2 first = pass.region.xy / CELL;
  const uint columns = (pass.region.x + pass.region.z + CELL - 1u) / CELL - first.x;
  const uvec2 cell = (pass.region.xy + place) / CELL - first;
  return texelFetch(countTexels, int(cell.y * columns + cell.x)).x;
}

// How many samples of the pass a place has; none outside the region.
uint samplesAt(int x, int y) {
  const bool exists = x >= 0 && y >= 0 && x < int(pass.region.z) && y < int(pass.region.w);
  const uint count = countAt(exists ? uvec2(x, y) : uvec2(0u));
  return exists && count > pass.samples.x ? count - pass.samples.x : 0u;
}

// Weighs sample s of a pixel of the region by one over the pixel's count: then a pixel with few
// samples means as much to its neighbours' filters as one with many. Beyond the count nothing was
// traced, and what lies there is of an earlier pass or of none.
void weighByCount(uvec2 place, uint s, inout vec3 radiance, inout float wx[REACH],
                  inout float wy[REACH]) {
  const uint count = countAt(place);
  const bool traced = pass.samples.x + s < count;
  const float share = 1.0 / float(count);
  radiance = traced ? radiance : vec3(0.0);
  [[unroll]] for (uint k = 0u; k < REACH; ++k) {
    wx[k] = traced ? wx[k] : 0.0;
    wy[k] = traced ? wy[k] * share : 0.0;
  }
}

#endif
