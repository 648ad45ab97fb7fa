#include "scene/emitters.h"

#include <fmt/format.h>

#include <initializer_list>

#include "scene/add_environment.h"
#include "scene/properties.h"
#include "scene/schema.h"

namespace laver {

// host/reference/emitter/NAME.cpp
namespace reference {
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

using xml::Draft;
using xml::Properties;

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

namespace {

using enum PropertyType;

void buildArea(const Properties& given, std::string_view parent, Draft& draft) {
  if (parent != "mesh") {
    given.error("radiance", fmt::format("{} stands in <{}>, expected it in <mesh>",
                                        nameOf(given.rule()), parent));
  } else if (!draft.meshes.empty()) {
    const double scale = given.real("scale");
    draft.meshes.back().light = {given.triple("radiance") * scale, scale};
    draft.meshes.back().lightOffset = given.offset();
  }
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
