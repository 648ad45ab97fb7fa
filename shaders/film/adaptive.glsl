// Adaptive sampling: cells of pixels have sample counts of their own, and workgroups take their work
// from a list.
#include "resources.glsl"

// The number of this workgroup: lists are cut into rows of workgroups.
uint groupNumber() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }

uvec3 listedWork(uint number) { return texelFetch(workTexels, int(pass.firstWork + number)).xyz; }

// Samples of a pixel of the region.
uint countAt(uvec2 place) {
  const uvec2 first = pass.region.xy / CELL;
  const uint columns = (pass.region.x + pass.region.z + CELL - 1u) / CELL - first.x;
  const uvec2 cell = (pass.region.xy + place) / CELL - first;
  return texelFetch(countTexels, int(cell.y * columns + cell.x)).x;
}

// What sample s of the pass counts for at a pixel of the region: one over the pixel's count, so that
// a pixel with few samples means as much to its neighbours' filters as one with many; 0 beyond it.
float shareOf(uvec2 place, uint s) {
  const uint count = countAt(place);
  return pass.firstSample + s < count ? 1.0 / float(count) : 0.0;
}
