// Triangle tests for the chart.
#include "shared/charted.h"
#include "shared/triangle.h"

struct TriangleHit {
  bool inside;
  float depth;
};

TriangleHit moellerTrumbore(vec3 origin, vec3 direction, vec3 a, vec3 b, vec3 c, float scale) {
  const vec3 edge1 = b - a, edge2 = c - a;
  const vec3 p = cross(direction, edge2);
  const float det = dot(edge1, p);
  const float inverse = 1.0 / det;
  const vec3 s = origin - a;
  const float u = dot(s, p) * inverse;
  const vec3 q = cross(s, edge1);
  const float v = dot(direction, q) * inverse;
  return TriangleHit(det != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0,
                     dot(edge2, q) * inverse * scale);
}

Edges plainEdges(Shear shear, vec3 a, vec3 b, vec3 c) {
  const vec2 slope = vec2(shear.u, shear.v);
  const vec2 p = a.xy - slope * a.z, q = b.xy - slope * b.z, r = c.xy - slope * c.z;
  Edges e;
  e.a = r.x * q.y - r.y * q.x;
  e.b = p.x * r.y - p.y * r.x;
  e.c = q.x * p.y - q.y * p.x;
  e.sum = e.a + e.b + e.c;
  e.inside = ((e.a >= 0.0 && e.b >= 0.0 && e.c >= 0.0) || (e.a <= 0.0 && e.b <= 0.0 && e.c <= 0.0)) &&
             e.sum != 0.0;
  return e;
}

TriangleHit triangleHit(Shear shear, vec3 origin, vec3 direction, vec3 a, vec3 b, vec3 c) {
  if (TRIANGLES == TRIANGLES_MOELLER)
    return moellerTrumbore(origin, direction, a, b, c, abs(alongAxis(direction, shear.axis)));
  const vec3 pa = permute(shear, a - origin), pb = permute(shear, b - origin);
  const vec3 pc = permute(shear, c - origin);
  if (TRIANGLES == TRIANGLES_PLAIN) {
    const Edges e = plainEdges(shear, pa, pb, pc);
    return TriangleHit(e.inside, (e.a * pa.z + e.b * pb.z + e.c * pc.z) / e.sum);
  }
  const Edges e = edgesOf(shear, pa, pb, pc);
  return TriangleHit(e.inside, depthOf(e, pa.z, pb.z, pc.z));
}
