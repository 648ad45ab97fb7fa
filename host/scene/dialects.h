#pragma once
#include "scene/rows.h"

namespace laver {

/// A family of course trees, where one scene file means something else than in another.
struct Dialect {
  const char* name;
  std::vector<const char*> spellings{};
  bool mirrored = false;        ///< the camera's +x is on the right of the film, not on the left
  bool emittersAbsorb = false;  ///< a surface that emits reflects nothing
  bool textmapMirrored = false;  ///< the texture `textmap` is mirrored in u, its values linear
};

/// "base" first, which is what a scene means if nothing is said.
const Rows<Dialect>& dialects();

}  // namespace laver
