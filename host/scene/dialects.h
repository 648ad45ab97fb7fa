#pragma once
#include <string_view>
#include <vector>

#include "scene/rows.h"

namespace laver {

/// How images of all directions lie in the space of an environment.
enum class Sky {
  YUp,          ///< as the image of an Environment
  YUpTurned,    ///< the same, half a turn around y
  YUpReversed,  ///< row 0 is -y; columns from +x over -z, -x and +z
  ZUpReversed,  ///< row 0 is +z; columns from +x over -y, -x and +y
  ZUp           ///< row 0 is +z; columns from +x over +y, -x and -y
};

/// A family of course trees, where one scene file means something else than in another.
struct Dialect {
  const char* name;
  std::vector<const char*> spellings{};
  /// Tags, or tags with types, that no other family has: a scene with one of them that is rendered
  /// without --dialect causes a hint.
  std::vector<std::string_view> vocabulary{};
  const char* difference = "";   ///< for that hint: what the dialect changes
  bool mirrored = false;         ///< the camera's +x is on the right of the film, not on the left
  bool scaledLookAt = false;     ///< <lookat> shrinks left and up by the sine between up and view
  double occlusionLength = 0.0;  ///< of `ao`, in diagonals of the scene; 0: endless
  Sky sky = Sky::YUp;
  bool encodedSky = false;       ///< values of a sky's image are divided by 255, those of EXR, too
  bool emittersAbsorb = false;   ///< a surface that emits reflects nothing
  bool textmapMirrored = false;  ///< the texture `textmap` is mirrored in u, its values linear
};

/// "base" first, which is what a scene means if nothing is said.
const Rows<Dialect>& dialects();

}  // namespace laver
