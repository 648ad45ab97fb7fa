// Adaptive sampling: each cell of pixels has its own sample count, and workgroups read their work from a
// list.
#include "resources.glsl"

// The index of this workgroup: long lists are dispatched as several rows of workgroups.
uint groupNumber() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }

uvec3 listedWork(uint number) { return texelFetch(workTexels, int(pass.firstWork + number)).xyz; }

// Sample count of a pixel of the region.
uint countAt(uvec2 place) {
  const uvec2 first = pass.region.xy / CELL;
  const uint columns = (pass.region.x + pass.region.z + CELL - 1u) / CELL - first.x;
  const uvec2 cell = (pass.region.xy + place) / CELL - first;
  return texelFetch(countTexels, int(cell.y * columns + cell.x)).x;
}

// The weight of sample s of the pass at a pixel of the region: one over the pixel's sample count, so that a
// pixel with few samples contributes as much to its neighbours as one with many; 0 beyond the count.
float shareOf(uvec2 place, uint s) {
  const uint count = countAt(place);
  return pass.firstSample + s < count ? 1.0 / float(count) : 0.0;
}
