// The `lane` traversal for scenes in which an invocation would exceed the loop iterations that a driver allows.
// A dispatch answers one query of each invocation, or several, from one portion of the tree; the host dispatches
// portion after portion, query after query (Frame::dispatchPortions()). Each dispatch runs the kernel from its
// beginning: earlier queries get their answers from a buffer, later ones get none. Only the dispatch with
// ALL_ANSWERED, in which no query gets none, stores samples and no answers.
#include "trace/lane_walk.glsl"
#include "trace/queries.glsl"

uint answerIndex(uint query) {
  const uvec3 n = gl_NumWorkGroups, g = gl_WorkGroupID;
  const uint group = (query * n.z + g.z) * n.y * n.x + g.y * n.x + g.x;
  return group * 64u + gl_LocalInvocationIndex;
}

bool answersNow(uint query) { return query >= pass.query && query - pass.query < pass.queryCount; }

void keepAnswer(uint query, uint answer) {
  if (pass.portion != ALL_ANSWERED) answers[answerIndex(query)] = answer;
}

// The answer to a query by the portions that were walked so far, or `none`.
uint answerTo(uint query, uint none) {
  const bool further = pass.portion > 0u && pass.portion != ALL_ANSWERED;
  const bool known = query < pass.query || (query == pass.query && further);
  return known ? answers[answerIndex(query)] : none;
}

// The answer is the slot of the nearest hit.
Hits closest(Rays rays) {
  const uint query = queries++;
  Hits hits;
  hits.slot[0] = answerTo(query, NO_HIT);
  if (answersNow(query)) {
    hits.slot[0] = closestLane(rays.origin[0], rays.direction[0], rays.tmin[0], rays.tmax[0],
                               rays.isActive[0], hits.slot[0]);
    keepAnswer(query, hits.slot[0]);
  }
  return hits;
}

Hits closestFromOne(Rays rays) { return closest(rays); }

// The answer is 1 if something blocks the segment, else 0.
bool unoccludedSoFar(vec3 from, vec3 direction, bool toLight, vec3 light, bool isActive) {
  const uint query = queries++;
  bool clear = isActive && answerTo(query, 0u) == 0u;
  if (answersNow(query)) {
    clear = unoccludedLane(from, direction, toLight, light, clear);
    keepAnswer(query, clear ? 0u : 1u);
  }
  return clear;
}

void unoccluded(Segments s, out bool clear[R]) {
  clear[0] = unoccludedSoFar(s.from[0], s.direction[0], false, vec3(0.0), s.isActive[0]);
}

void unoccludedToOne(vec3 light, vec3 points[R], bool isActive[R], out bool clear[R]) {
  clear[0] = unoccludedSoFar(points[0], light - points[0], true, light, isActive[0]);
}
