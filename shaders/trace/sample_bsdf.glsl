// Directions that a BSDF draws, their densities, and its values. No render uses it, but tests of hypotheses.
#include "shared/bsdf_query.h"

layout(local_size_x = 64) in;
layout(binding = BINDINGS) readonly buffer QuestionBlock { BsdfQuestion questionOf[]; };
layout(binding = BINDINGS + 1) writeonly buffer AnswerBlock { BsdfAnswer answerOf[]; };
// Here Pass holds: region.x the count, region.y the material.

void main() {
  const uint n = gl_GlobalInvocationID.x;
  if (n >= pass.region.x) return;
  const BsdfQuestion q = questionOf[n];
  Surface s;
  s.position = vec3(0.0);
  s.geometric = s.normal = vec3(0.0, 0.0, 1.0);
  s.t = s.offset = 0.0;
  s.material = pass.region.y;
  s.weights = vec3(1.0 - q.uv.x - q.uv.y, q.uv);
  s.id = s.slot = pass.region.y;  // a triangle per material
  const Material m = materialOf(s);
  BsdfAnswer a;
  a.weight = sampleBsdf(m, s.normal, q.wi, vec2(q.first, q.second), a.wo);
  if (q.wo != vec3(0.0)) {
    a.wo = q.wo;
    a.weight = vec3(0.0);
  }
  a.pdf = pdfBsdf(m, s.normal, q.wi, a.wo);
  a.value = evalBsdf(m, s.normal, q.wi, a.wo, vec3(1.0));
  a.unused0 = a.unused1 = 0.0;
  answerOf[n] = a;
}
