#include "scene/dialects.h"

namespace laver {

const Rows<Dialect>& dialects() {
  static const Dialect base{.name = "base"}, eth{.name = "eth", .mirrored = true},
      dartmouth{.name = "dartmouth", .mirrored = true},
      zaragoza{.name = "zaragoza", .emittersAbsorb = true, .textmapMirrored = true},
      nori1{.name = "nori1", .mirrored = true};
  static const Rows<Dialect> rows = {&base, &eth, &dartmouth, &zaragoza, &nori1};
  return rows;
}

}  // namespace laver
