// Questions to a BSDF, and the answers of trace/sample_bsdf.glsl, both in storage buffers.
#ifndef LAVER_SHARED_BSDF_QUERY_H
#define LAVER_SHARED_BSDF_QUERY_H
#include "shared/types.h"

LAVER_SHARED_BEGIN

struct BsdfQuestion {
  vec3 wi;
  float first;  // number by which wo is drawn
  vec3 wo;      // given, or 0: it is drawn
  float second;
  vec2 uv;
  vec2 unused;
};

struct BsdfAnswer {
  vec3 wo;
  float pdf;
  vec3 weight;  // of the sample; 0 where wo was given
  float unused0;
  vec3 value;  // for wi and wo
  float unused1;
};

LAVER_SHARED_END

#endif
