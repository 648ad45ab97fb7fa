#include "scene/cameras.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <optional>

#include "scene/properties.h"
#include "scene/schema.h"

namespace laver {
namespace {

using xml::Draft;
using xml::Properties;
using enum PropertyType;

std::vector<PropertyRow> pinholeProperties() {
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

PropertyRow lengthRow(const char* name, Value start, bool required, const char* meaning) {
  return {.name = name,
          .type = Float,
          .start = std::move(start),
          .required = required,
          .unit = "camera units",
          .meaning = meaning};
}

/// A lens has two names in each tree. `radius`: the default.
std::vector<PropertyRow> lensProperties(const char* radiusName, double radius,
                                        const char* distanceName, std::optional<double> distance) {
  std::vector<PropertyRow> rows = pinholeProperties();
  rows.push_back(lengthRow(radiusName, radius, false, "of the lens; 0 or less: a pinhole"));
  rows.push_back(lengthRow(distanceName, distance.value_or(1.0), !distance,
                           "of the plane in focus, along the camera's axis"));
  rows.back().range = moreThan(0.0);
  return rows;
}

/// The names of a lens within `perspective`: radius, distance.
constexpr std::array<std::array<const char*, 2>, 3> kLensNames{
    {{"lensRadius", "focalDistance"}, {"apertureRadius", "focusDistance"}, {"", "focalLength"}}};

std::vector<PropertyRow> perspectiveProperties() {
  std::vector<PropertyRow> rows = pinholeProperties();
  for (const auto& [radius, distance] : kLensNames) {
    if (*radius != '\0')
      rows.push_back(lengthRow(radius, 0.0, false, "of a lens; 0 or less: a pinhole"));
    rows.push_back(
        lengthRow(distance, 1.0, false, "of the plane in focus, along the camera's axis"));
    rows.back().range = moreThan(0.0);
  }
  rows.push_back({.name = "bokeh",
                  .type = Boolean,
                  .start = false,
                  .meaning = "whether there is a lens, if focalLength is given"});
  return rows;
}

void setLens(double radius, double distance, Camera& camera) {
  if (!(radius > 0.0)) return;
  camera.row = &cameras::thinlens;
  camera.lensRadius = radius;
  camera.focalDistance = distance;
}

void buildPinhole(const Properties& given, Draft& draft) {
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

void buildPerspective(const Properties& given, std::string_view, Draft& draft) {
  buildPinhole(given, draft);
  const auto isGiven = [&](const char* name) { return given.wasGiven(given.find(name)); };
  double radius = 0.0;
  const char* radiusName = nullptr;
  std::optional<double> distance;
  for (const auto& [radiusOf, distanceOf] : kLensNames) {
    if (*radiusOf != '\0' && isGiven(radiusOf)) {
      radius = given.real(radiusOf);
      radiusName = radiusOf;
    }
    if (isGiven(distanceOf)) distance = given.real(distanceOf);
  }
  if (!(radius > 0.0) || (isGiven("focalLength") && !given.boolean("bokeh"))) return;
  if (!distance)
    return given.error(radiusName, fmt::format("{} needs focalDistance, the distance of the plane "
                                               "in focus in camera units",
                                               radiusName));
  setLens(radius, *distance, draft.scene.camera);
}

/// A form whose last two properties are those of a lens.
void buildLens(const Properties& given, std::string_view, Draft& draft) {
  buildPinhole(given, draft);
  const auto rows = given.rule().properties;
  if (given.has(rows.back().name))
    setLens(given.real(rows[rows.size() - 2].name), given.real(rows.back().name),
            draft.scene.camera);
}

}  // namespace

namespace cameras {

const CameraRow perspective{
    .name = "perspective",
    .object = "PerspectiveCamera",
    .forms = {
        {.type = "perspective", .properties = perspectiveProperties(), .build = buildPerspective}}};

const CameraRow thinlens{
    .name = "thinlens",
    .object = "ThinLensCamera",
    .forms = {{.type = "thinlens",
               .properties = lensProperties("aperture_radius", 0.0, "focus_distance", {}),
               .build = buildLens},
              {.type = "depthoffield",
               .properties = lensProperties("lensradius", -1.0, "focaldistance", {}),
               .build = buildLens},
              {.type = "dofCamera",
               .properties = lensProperties("lensRadius", 0.2, "focalDistance", 5.0),
               .build = buildLens}},
    .lens = true};

}  // namespace cameras

const Rows<CameraRow>& cameraRows() {
  static const Rows<CameraRow> rows = {&cameras::perspective, &cameras::thinlens};
  return rows;
}

}  // namespace laver
