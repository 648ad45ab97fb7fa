#include "scene/emitters.h"

#include <fmt/format.h>

#include <numbers>

#include "scene/properties.h"
#include "scene/schema.h"

namespace laver {

// host/reference/emitter/NAME.cpp
namespace reference {
LightSample point(const PointLight& light, const glm::dvec3& from);
glm::dvec3 environment(const Environment& environment, const glm::dvec3& direction);
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

void addEnvironment(const Properties& given, std::string_view parent,
                    const Environment& environment, Draft& draft) {
  if (parent != "scene") {
    given.error("radiance", fmt::format("{} stands in <{}>, expected it in <scene>",
                                        nameOf(given.rule()), parent));
  } else if (draft.scene.environment) {
    given.error("radiance",
                fmt::format("{} is a second background, expected one", nameOf(given.rule())));
  } else {
    draft.scene.environment = environment;
    draft.environmentOffset = given.offset();
  }
}

void buildEnvironment(const Properties& given, std::string_view parent, Draft& draft) {
  Environment environment;
  environment.radiance = given.triple("radiance") * given.real("scale");
  environment.toWorld = given.transform("toWorld");
  environment.filename = given.text("filename");
  environment.raw = given.boolean("raw") || draft.overrides.noriCompat;
  addEnvironment(given, parent, environment, draft);
}

// Dialects name its file in other ways; white would be a wrong guess.
void buildEnvmap(const Properties& given, std::string_view parent, Draft& draft) {
  if (needsShading(draft) && !given.wasGiven(given.find("filename")) &&
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

PropertyRow backgroundRow(const char* meaning) {
  return {.name = "radiance", .type = Color, .start = Environment{}.radiance, .meaning = meaning};
}

std::vector<PropertyRow> environmentProperties() {
  const Environment environment;
  return {{.name = "filename",
           .type = String,
           .meaning = "picture in longitude and latitude; none: one radiance"},
          backgroundRow("of all directions, or the picture's factor"),
          {.name = "scale", .type = Float, .start = 1.0, .meaning = "factor of the radiance"},
          {.name = "raw",
           .type = Boolean,
           .start = environment.raw,
           .meaning = "8-bit and 16-bit values are linear, not sRGB"},
          {.name = "toWorld",
           .type = Transform,
           .start = environment.toWorld,
           .meaning = "from the picture's directions"}};
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
                               .meaning = "4 pi times what a pointlight calls its radiance"}},
               .build = buildPowerLight}},
    .sample = reference::point};

const EmitterRow environment{
    .name = "environment",
    .object = "EnvironmentEmitter",
    .forms = {{.type = "environment",
               .properties = environmentProperties(),
               .build = buildEnvironment},
              {.type = "envmap", .properties = environmentProperties(), .build = buildEnvmap},
              {.type = "constant",
               .properties = {backgroundRow("of all directions")},
               .build = buildConstant}},
    .background = reference::environment};

}  // namespace emitters

const Rows<EmitterRow>& emitterRows() {
  using namespace emitters;
  static const Rows<EmitterRow> rows = {&point, &environment};
  return rows;
}

}  // namespace laver
