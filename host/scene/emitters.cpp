#include "scene/emitters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "scene/properties.h"
#include "scene/schema.h"
#include "scene/transform.h"

namespace laver {

// host/reference/emitter/NAME.cpp
namespace reference {
LightSample point(const PointLight& light, const glm::dvec3& from, double reach);
LightSample spot(const PointLight& light, const glm::dvec3& from, double reach);
LightSample directional(const PointLight& light, const glm::dvec3& from, double reach);
glm::dvec3 environment(const Environment& environment, const glm::dvec3& direction);
glm::dvec3 constant(const Environment& environment, const glm::dvec3& direction);
glm::dvec3 distantdisk(const Environment& environment, const glm::dvec3& direction);
DirectionSample environmentDirection(const Environment& environment, glm::ivec2 grid,
                                     std::size_t cell, glm::dvec2 numbers);
DirectionSample constantDirection(const Environment& environment, glm::ivec2 grid, std::size_t cell,
                                  glm::dvec2 numbers);
DirectionSample distantdiskDirection(const Environment& environment, glm::ivec2 grid,
                                     std::size_t cell, glm::dvec2 numbers);
CellDensity environmentDensity(const Environment& environment, glm::ivec2 grid,
                               const glm::dvec3& direction);
CellDensity constantDensity(const Environment& environment, glm::ivec2 grid,
                            const glm::dvec3& direction);
CellDensity distantdiskDensity(const Environment& environment, glm::ivec2 grid,
                               const glm::dvec3& direction);
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

void addEnvironment(const Properties& given, std::string_view parent,
                    const Environment& environment, Draft& draft);

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
  const glm::dvec3 z = -light.axis;
  const glm::dvec3 aside = std::abs(z.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = normalizedOrZero(glm::cross(aside, z));
  disk.toWorld = glm::dmat4(glm::dmat3(x, glm::cross(z, x), z));
  addEnvironment(given, parent, disk, draft);
}

void buildArea(const Properties& given, std::string_view parent, Draft& draft) {
  if (parent != "mesh") {
    given.error("radiance", fmt::format("{} stands in <{}>, expected it in <mesh>",
                                        nameOf(given.rule()), parent));
  } else if (!draft.meshes.empty()) {
    draft.meshes.back().light = {given.triple("radiance") * given.real("scale")};
    draft.meshes.back().lightOffset = given.offset();
  }
}

/// In a mesh, an image takes the place of the mesh.
void addEnvironment(const Properties& given, std::string_view parent,
                    const Environment& environment, Draft& draft) {
  if (parent == "mesh" && environment.row != &emitters::environment) {
    given.error("radiance",
                fmt::format("{} is in <mesh>, expected in <scene>", nameOf(given.rule())));
    return;
  }
  if (draft.scene.environment) {
    given.error("radiance",
                fmt::format("{} is a second background, expected one", nameOf(given.rule())));
    return;
  }
  draft.scene.environment = environment;
  draft.environmentOffset = given.offset();
  if (parent != "mesh" || draft.meshes.empty()) return;
  draft.meshes.back().isSky = true;
  given.note(fmt::format("{} is in a mesh, which is not rendered: the background is infinitely far",
                         nameOf(given.rule())));
}

/// From the picture's space (Environment) to that of the environment.
glm::dmat4 orientationOf(Sky sky) {
  switch (sky) {
    case Sky::YUp:
      break;
    case Sky::YUpTurned:  // (-x, y, -z) of a direction is that of the picture
      return {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1};
    case Sky::YUpReversed:  // (-z, -y, -x)
      return {0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 1};
    case Sky::ZUpReversed:  // (-y, z, -x)
      return {0, -1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, 0, 0, 1};
    case Sky::ZUp:  // (y, z, -x)
      return {0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 0, 0, 0, 0, 1};
  }
  return glm::dmat4(1.0);
}

/// The first of these properties whose text is not empty, or nullptr.
const char* firstText(const Properties& given, std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (!given.text(name).empty()) return name;
  return nullptr;
}

void buildEnvironment(const Properties& given, std::string_view parent, Draft& draft) {
  const Dialect& dialect = *draft.overrides.dialect;
  Environment environment;
  environment.radiance = given.triple("radiance") * given.real("scale");
  const double radianceScale = given.real("radiance_scale"), strength = given.real("strength");
  for (const double factor : {radianceScale, strength})
    if (factor != 0.0) environment.radiance *= factor;
  // Trees whose pictures lie otherwise have other names for some property.
  Sky sky = dialect.sky;
  if (radianceScale != 0.0) sky = Sky::ZUpReversed;
  if (parent == "mesh" || strength != 0.0 || firstText(given, {"mapname", "path2map"}))
    sky = Sky::ZUp;
  environment.toWorld = given.transform("toWorld") * orientationOf(sky);
  if (const char* name = firstText(given, {"filename", "mapname", "path2map"}))
    environment.filename = given.text(name);
  if (!environment.filename.empty()) environment.row = &emitters::environment;
  environment.raw = given.boolean("raw") || draft.overrides.noriCompat || dialect.encodedSky;
  environment.encoded = dialect.encodedSky;
  addEnvironment(given, parent, environment, draft);
}

// Other trees name the file differently, and a white default would be wrong.
void buildEnvmap(const Properties& given, std::string_view parent, Draft& draft) {
  if (needsShading(draft) && !firstText(given, {"filename", "mapname", "path2map"}) &&
      !given.wasGiven(given.find("radiance"))) {
    given.error("filename", fmt::format("{} needs <string name=\"filename\"> or <color "
                                        "name=\"radiance\">",
                                        nameOf(given.rule())));
  }
  buildEnvironment(given, parent, draft);
}

void buildConstant(const Properties& given, std::string_view parent, Draft& draft) {
  Environment environment;
  environment.radiance = given.triple("radiance");
  addEnvironment(given, parent, environment, draft);
}

void buildDistantDisk(const Properties& given, std::string_view parent, Draft& draft) {
  if (!given.has("radiance") || !given.has("thetaA")) return;
  Environment environment;
  environment.row = &emitters::distantdisk;
  environment.radiance = given.triple("radiance");
  environment.angle = given.real("thetaA");
  environment.toWorld = given.transform("toWorld");
  addEnvironment(given, parent, environment, draft);
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

PropertyRow backgroundRow(const char* meaning) {
  return {.name = "radiance", .type = Color, .start = Environment{}.radiance, .meaning = meaning};
}

std::vector<PropertyRow> environmentProperties() {
  const Environment environment;
  return {{.name = "filename",
           .type = String,
           .meaning = "image by longitude and latitude; without one, a constant radiance"},
          backgroundRow("radiance, or factor of the image"),
          {.name = "scale", .type = Float, .start = 1.0, .meaning = "factor of the radiance"},
          {.name = "mapname", .type = String, .meaning = "as filename; +z is up"},
          {.name = "path2map", .type = String, .meaning = "as filename; +z is up"},
          {.name = "radiance_scale",
           .type = Float,
           .start = 0.0,
           .meaning = "factor of the radiance, and +z is up; 0: neither"},
          {.name = "strength",
           .type = Float,
           .start = 0.0,
           .meaning = "factor of the radiance, and +z is up; 0: neither"},
          {.name = "raw",
           .type = Boolean,
           .start = environment.raw,
           .meaning = "8-bit and 16-bit values are linear, not sRGB"},
          {.name = "toWorld",
           .type = Transform,
           .start = environment.toWorld,
           .meaning = "from the image's directions"}};
}

std::string describeImage(const Environment& environment) {
  return fmt::format("environment = \"{}\"", environment.filename);
}

std::string describeDisk(const Environment& environment) {
  return fmt::format("thetaA = {:f}", environment.angle);
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

const EmitterRow area{.name = "area",
                      .object = "AreaLight",
                      .forms = {{.type = "area",
                                 .properties = {{.name = "radiance",
                                                 .type = Color,
                                                 .start = AreaLight{}.radiance,
                                                 .meaning = "of the mesh's surface, on the side "
                                                            "of its shading normal"},
                                                {.name = "scale",
                                                 .type = Float,
                                                 .start = 1.0,
                                                 .meaning = "factor of the radiance"}},
                                 .build = buildArea}}};

const EmitterRow environment{
    .name = "environment",
    .object = "EnvironmentEmitter",
    .forms = {{.type = "environment",
               .properties = environmentProperties(),
               .build = buildEnvironment},
              {.type = "envmap", .properties = environmentProperties(), .build = buildEnvmap}},
    .describe = describeImage,
    .background = reference::environment,
    .direction = reference::environmentDirection,
    .density = reference::environmentDensity};

const EmitterRow constant{.name = "constant",
                          .object = "EnvironmentEmitter",
                          .forms = {{.type = "constant",
                                     .properties = {backgroundRow("of all directions")},
                                     .build = buildConstant}},
                          .describe = describeImage,
                          .background = reference::constant,
                          .direction = reference::constantDirection,
                          .density = reference::constantDensity};

const EmitterRow distantdisk{
    .name = "distantdisk",
    .object = "DistantDisk",
    .forms = {{.type = "distantdisk",
               .properties = {{.name = "radiance",
                               .type = Color,
                               .start = Environment{}.radiance,
                               .required = true,
                               .meaning = "of directions within the disk"},
                              {.name = "thetaA",
                               .type = Float,
                               .start = Environment{}.angle,
                               .required = true,
                               .range = fromTo(1e-9, 180.0),
                               .unit = "degrees",
                               .meaning = "angular radius of the disk"},
                              {.name = "toWorld",
                               .type = Transform,
                               .start = Environment{}.toWorld,
                               .meaning = "takes +z to the direction of the disk's centre"}},
               .build = buildDistantDisk}},
    .describe = describeDisk,
    .background = reference::distantdisk,
    .direction = reference::distantdiskDirection,
    .density = reference::distantdiskDensity};

}  // namespace emitters

const Rows<EmitterRow>& emitterRows() {
  using namespace emitters;
  static const Rows<EmitterRow> rows = {&point,       &spot,     &directional, &area,
                                        &environment, &constant, &distantdisk};
  return rows;
}

}  // namespace laver
