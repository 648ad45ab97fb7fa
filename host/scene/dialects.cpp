#include "scene/dialects.h"

namespace laver {

const Rows<Dialect>& dialects() {
  static const Dialect base{.name = "base"},
      eth{.name = "eth",
          .vocabulary = {"emitter point", "emitter distantdisk", "integrator direct",
                         "integrator photonmapper", "texture checkerboard_color",
                         "texture checkerboard_float", "camera depthoffield", "camera dofCamera"},
          .difference = "the camera is the mirror image",
          .mirrored = true,
          .sky = Sky::ZUpReversed},
      dartmouth{.name = "dartmouth", .mirrored = true},
      zaragoza{.name = "zaragoza",
               .vocabulary = {"integrator path_nee"},
               .difference = "what emits does not reflect, and images are mirrored",
               .sky = Sky::YUpReversed,
               .encodedSky = true,
               .emittersAbsorb = true,
               .textmapMirrored = true},
      nori1{.name = "nori1",
            .vocabulary = {"luminaire", "integrator mipath"},
            .difference = "the camera is the mirror image",
            .mirrored = true,
            .scaledLookAt = true,
            .occlusionLength = 0.1,
            .sky = Sky::YUpTurned};
  static const Rows<Dialect> rows = {&base, &eth, &dartmouth, &zaragoza, &nori1};
  return rows;
}

}  // namespace laver
