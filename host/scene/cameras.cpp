#include "scene/cameras.h"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "scene/properties.h"
#include "scene/schema.h"

namespace laver {
namespace {

using xml::Draft;
using xml::Properties;
using enum PropertyType;

std::vector<PropertyRow> perspectiveProperties() {
  constexpr Range kPixels = fromTo(1, std::numeric_limits<int>::max());
  const Camera camera;
  return {
      {.name = "toWorld",
       .type = Transform,
       .start = camera.toWorld,
       .meaning = "from the camera, which looks along +z with +x to the left and +y up"},
      {.name = "width",
       .type = Integer,
       .start = std::int64_t{camera.width},
       .range = kPixels,
       .unit = "pixels",
       .meaning = "of the film"},
      {.name = "height",
       .type = Integer,
       .start = std::int64_t{camera.height},
       .range = kPixels,
       .unit = "pixels",
       .meaning = "of the film"},
      {.name = "fov",
       .type = Float,
       .start = camera.fov,
       .range = between(0.0, 180.0),
       .unit = "degrees",
       .meaning = "horizontal field of view"},
      {.name = "nearClip",
       .type = Float,
       .start = camera.nearClip,
       .range = moreThan(0.0),
       .unit = "camera units",
       .meaning = "nothing in front of this plane is seen"},
      {.name = "farClip",
       .type = Float,
       .start = camera.farClip,
       .unit = "camera units",
       .meaning = "nothing behind this plane is seen; more than nearClip"},
  };
}

void buildPerspective(const Properties& given, std::string_view, Draft& draft) {
  using Pixels = std::optional<std::int64_t>;
  Camera& camera = draft.scene.camera;
  const auto& size = draft.overrides.size;
  camera.toWorld = given.transform("toWorld");
  if (draft.overrides.dialect->mirrored) camera.toWorld[0] = -camera.toWorld[0];
  camera.width = static_cast<int>(given.integer("width", size ? Pixels(size->x) : Pixels()));
  camera.height = static_cast<int>(given.integer("height", size ? Pixels(size->y) : Pixels()));
  camera.fov = given.real("fov");
  camera.nearClip = given.real("nearClip");
  camera.farClip = given.real("farClip");
  constexpr std::int64_t kMaxPixels = std::numeric_limits<int>::max();
  if (std::int64_t{camera.width} * camera.height > kMaxPixels) {
    given.error("width", fmt::format("a film of {}x{} has more than {} pixels", camera.width,
                                     camera.height, kMaxPixels));
  }
  if (!(camera.farClip > camera.nearClip)) {
    given.error("farClip", fmt::format("farClip must be more than nearClip ({}), found {}",
                                       camera.nearClip, camera.farClip));
  }
}

}  // namespace

namespace cameras {

const CameraRow perspective{
    .name = "perspective",
    .object = "PerspectiveCamera",
    .forms = {
        {.type = "perspective", .properties = perspectiveProperties(), .build = buildPerspective}}};

}  // namespace cameras

const Rows<CameraRow>& cameraRows() {
  static const Rows<CameraRow> rows = {&cameras::perspective};
  return rows;
}

}  // namespace laver
