#include "scene/dialects.h"

namespace laver {

const Rows<Dialect>& dialects() {
  static const Dialect base{.name = "base"},
      eth{.name = "eth", .mirrored = true, .sky = Sky::ZUpReversed},
      dartmouth{.name = "dartmouth", .mirrored = true},
      zaragoza{.name = "zaragoza",
               .sky = Sky::YUpReversed,
               .encodedSky = true,
               .emittersAbsorb = true,
               .textmapMirrored = true},
      nori1{.name = "nori1",
            .mirrored = true,
            .scaledLookAt = true,
            .occlusionLength = 0.1,
            .sky = Sky::YUpTurned};
  static const Rows<Dialect> rows = {&base, &eth, &dartmouth, &zaragoza, &nori1};
  return rows;
}

}  // namespace laver
