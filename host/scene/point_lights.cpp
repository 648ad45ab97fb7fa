// Lights without extent: point, spot and directional ones.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/add_environment.h"
#include "scene/properties.h"
#include "scene/schema.h"
#include "scene/transform.h"

namespace laver {

// host/reference/emitter/NAME.cpp
namespace reference {
LightSample point(const PointLight& light, const glm::dvec3& from, double reach);
LightSample spot(const PointLight& light, const glm::dvec3& from, double reach);
LightSample directional(const PointLight& light, const glm::dvec3& from, double reach);
}  // namespace reference

namespace {

using xml::Draft;
using xml::Properties;
using enum PropertyType;

void addLight(const PointLight& light, std::string_view parent, Draft& draft) {
  (parent == "mesh" ? draft.meshLights : draft.scene.lights).push_back(light);
}

PropertyRow positionRow() {
  return {.name = "position",
          .type = Point,
          .start = PointLight{}.position,
          .unit = kSceneUnits,
          .meaning = "in the world"};
}

void buildPointLight(const Properties& given, std::string_view parent, Draft& draft) {
  addLight({given.triple("position"), given.triple("radiance")}, parent, draft);
}

void buildPowerLight(const Properties& given, std::string_view parent, Draft& draft) {
  if (!given.has("power")) return;
  const glm::dvec3 radiance = given.triple("power") / (4.0 * std::numbers::pi);
  addLight({given.triple("position"), radiance}, parent, draft);
}

/// Along which a light travels; reports a direction of no length.
glm::dvec3 axisOf(const Properties& given, const char* name, const glm::dvec3& direction) {
  const glm::dvec3 axis = normalizedOrZero(direction);
  if (axis == glm::dvec3(0.0))
    given.error(name, fmt::format("{} has no direction: expected one of a length", name));
  return axis;
}

void addSpot(const Properties& given, std::string_view parent, PointLight light, Draft& draft) {
  light.row = &emitters::spot;
  light.position = given.triple("position");
  if (light.inner > light.outer) std::swap(light.inner, light.outer);
  addLight(light, parent, draft);
}

double cosine(double degrees) { return std::cos(glm::radians(degrees)); }

/// `power` with a square, or `color` with a linear fall.
void buildSpotlight(const Properties& given, std::string_view parent, Draft& draft) {
  PointLight light;
  light.outer = given.real("cosTotalWidth");
  light.inner = given.real("cosFalloffStart");
  light.axis = axisOf(given, "direction", given.triple("direction"));
  const bool colored = given.triple("color") != glm::dvec3(0.0);
  light.falloff = colored ? Falloff::Angle : Falloff::Square;
  light.radiance = given.triple(colored ? "color" : "power") / (4.0 * std::numbers::pi);
  addSpot(given, parent, light, draft);
}

/// Three trees have three sets of properties.
void buildSpot(const Properties& given, std::string_view parent, Draft& draft) {
  PointLight light;
  if (given.real("cone") != 0.0) {
    light.outer = given.real("cone");
    light.inner = given.real("falloff");
    light.axis = axisOf(given, "target", given.triple("target") - given.triple("position"));
    light.falloff = Falloff::Projected;
    light.radiance = given.triple("power") * (1.0 - cosine(light.outer)) /
                     (1.0 - 0.5 * (cosine(light.inner) + cosine(light.outer)));
  } else if (given.real("totalwidth") != 0.0) {
    light.outer = 0.5 * given.real("totalwidth");
    light.inner = given.real("falloffstart");
    light.axis = axisOf(given, "direction", given.triple("direction"));
    light.falloff = Falloff::Quartic;
    light.radiance =
        given.triple("power") /
        (2.0 * std::numbers::pi * (1.0 - 0.5 * (cosine(light.inner) + cosine(light.outer))));
  } else {
    light.outer = given.real("thetaMax");
    light.inner = std::max(light.outer - given.real("thetaFall"), 0.0);
    light.axis = axisOf(given, "toWorld",
                        glm::dmat3(given.transform("toWorld")) * glm::dvec3(0.0, 0.0, -1.0));
    light.radiance = given.triple("intensity") * given.triple("baseColor");
  }
  addSpot(given, parent, light, draft);
}

/// With an angle, it is a disk of the background.
void buildDirectional(const Properties& given, std::string_view parent, Draft& draft) {
  PointLight light;
  light.row = &emitters::directional;
  light.axis = axisOf(given, "direction", given.triple("direction"));
  light.radiance = given.triple("radiance");
  const double angle = given.real("angle");
  if (angle == 0.0) return addLight(light, parent, draft);
  Environment disk;
  disk.row = &emitters::distantdisk;
  disk.radiance = light.radiance;
  disk.angle = angle;
  const glm::dvec3 aside = std::abs(light.axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  disk.toWorld = lookAt(glm::dvec3(0.0), -light.axis, aside).value_or(glm::dmat4(1.0));
  addEnvironment(given, parent, disk, draft);
}

PropertyRow angleRow(const char* name, double start, double most, const char* meaning) {
  return {.name = name,
          .type = Float,
          .start = start,
          .range = fromTo(0.0, most),
          .unit = "degrees",
          .meaning = meaning};
}

PropertyRow colorRow(const char* name, double start, const char* meaning) {
  return {.name = name, .type = Color, .start = glm::dvec3(start), .meaning = meaning};
}

PropertyRow directionalRadiance() {
  PropertyRow row = colorRow("radiance", 1.0, "that arrives everywhere; also called power");
  row.spelling = "power";
  return row;
}

PropertyRow directionRow(const char* meaning) {
  return {.name = "direction", .type = Vector, .start = PointLight{}.axis, .meaning = meaning};
}

std::vector<PropertyRow> spotlightProperties() {
  return {positionRow(),
          directionRow("along which the light travels"),
          colorRow("power", 1.0, "4 pi times the intensity along the axis; falls as a square"),
          colorRow("color", 0.0, "if not 0, in place of power; falls linearly in the angle"),
          angleRow("cosTotalWidth", 30.0, 180.0, "from the axis: no light from there on"),
          angleRow("cosFalloffStart", 20.0, 180.0, "from the axis: full intensity up to there")};
}

std::vector<PropertyRow> spotProperties() {
  return {positionRow(),
          {.name = "target",
           .type = Point,
           .start = glm::dvec3(0.0),
           .unit = kSceneUnits,
           .meaning = "of the axis, with cone"},
          angleRow("cone", 0.0, 180.0, "if not 0: from the axis, no light from there on"),
          angleRow("falloff", 0.0, 180.0, "from the axis: full intensity up to there"),
          directionRow("of the axis, with totalwidth"),
          angleRow("totalwidth", 0.0, 360.0, "if not 0: of the whole cone"),
          angleRow("falloffstart", 10.0, 180.0, "from the axis: full intensity up to there"),
          colorRow("power", 1.0, "with cone or totalwidth"),
          colorRow("intensity", 1000.0, "along the axis, with neither cone nor totalwidth"),
          colorRow("baseColor", 1.0, "factor of intensity"),
          angleRow("thetaMax", 30.0, 180.0, "from the axis: no light from there on"),
          angleRow("thetaFall", 5.0, 180.0, "over which the intensity falls to 0"),
          {.name = "toWorld",
           .type = Transform,
           .start = glm::dmat4(1.0),
           .meaning = "takes -z to the axis"}};
}

}  // namespace

namespace emitters {

const EmitterRow point{
    .name = "point",
    .object = "PointEmitter",
    .forms = {{.type = "pointlight",
               .properties = {positionRow(),
                              {.name = "radiance",
                               .type = Color,
                               .start = PointLight{}.radiance,
                               .meaning = "radiance / distance^2 arrives at a surface"}},
               .build = buildPointLight},
              {.type = "point",
               .properties = {positionRow(),
                              {.name = "power",
                               .type = Color,
                               .start = glm::dvec3(0.0),
                               .required = true,
                               .meaning = "4 pi times the radiance of a pointlight"}},
               .build = buildPowerLight}},
    .sample = reference::point};

const EmitterRow spot{
    .name = "spot",
    .object = "SpotLight",
    .forms = {{.type = "spotlight", .properties = spotlightProperties(), .build = buildSpotlight},
              {.type = "spot", .properties = spotProperties(), .build = buildSpot}},
    .sample = reference::spot};

const EmitterRow directional{
    .name = "directional",
    .object = "DirectionalLight",
    .forms = {{.type = "directional",
               .properties = {directionRow("along which the light travels"), directionalRadiance(),
                              angleRow("angle", 0.0, 180.0,
                                       "more than 0: a distantdisk of that angular radius")},
               .build = buildDirectional}},
    .sample = reference::directional};

}  // namespace emitters

}  // namespace laver
