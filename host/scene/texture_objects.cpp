#include "scene/texture_objects.h"

#include <fmt/format.h>

namespace laver::xml {
namespace {

void place(const Properties& given, Texture& texture) {
  texture.scale = {given.real("scalex"), given.real("scaley")};
  texture.offset = {given.real("offsetx"), given.real("offsety")};
}

void addTexture(const Properties& given, const Texture& texture, Draft& draft) {
  if (draft.meshes.empty()) return;
  draft.meshes.back().bsdf.texture = texture;
  draft.meshes.back().textureOffset = given.offset();
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

}  // namespace

const std::vector<PropertyRow> kChecker = {
    {.name = "color1", .type = PropertyType::Color, .start = Texture{}.colors[0]},
    {.name = "color2", .type = PropertyType::Color, .start = Texture{}.colors[1]},
    {.name = "scalex", .type = PropertyType::Float, .start = Texture{}.scale.x},
    {.name = "scaley", .type = PropertyType::Float, .start = Texture{}.scale.y},
    {.name = "offsetx", .type = PropertyType::Float, .start = Texture{}.offset.x},
    {.name = "offsety", .type = PropertyType::Float, .start = Texture{}.offset.y}};

const std::vector<PropertyRow> kTextmap = {
    {.name = "filename", .type = PropertyType::String, .required = true},
    {.name = "color", .type = PropertyType::Color, .start = glm::dvec3(1.0)},
    {.name = "raw", .type = PropertyType::Boolean, .start = Texture{}.raw},
    {.name = "scalex", .type = PropertyType::Float, .start = Texture{}.scale.x},
    {.name = "scaley", .type = PropertyType::Float, .start = Texture{}.scale.y},
    {.name = "offsetx", .type = PropertyType::Float, .start = Texture{}.offset.x},
    {.name = "offsety", .type = PropertyType::Float, .start = Texture{}.offset.y}};

const std::vector<PropertyRow> kEnvironment = {
    {.name = "filename", .type = PropertyType::String},
    {.name = "radiance", .type = PropertyType::Color, .start = Environment{}.radiance},
    {.name = "scale", .type = PropertyType::Float, .start = 1.0},
    {.name = "raw", .type = PropertyType::Boolean, .start = Environment{}.raw},
    {.name = "toWorld", .type = PropertyType::Transform, .start = Environment{}.toWorld}};

const std::vector<PropertyRow> kConstant = {
    {.name = "radiance", .type = PropertyType::Color, .start = Environment{}.radiance}};

void buildChecker(const Properties& given, std::string_view, Draft& draft) {
  Texture texture;
  texture.colors = {given.triple("color1"), given.triple("color2")};
  place(given, texture);
  addTexture(given, texture, draft);
}

void buildTextmap(const Properties& given, std::string_view, Draft& draft) {
  if (!given.has("filename")) return;
  Texture texture;
  texture.kind = Texture::Kind::Image;
  texture.filename = given.text("filename");
  texture.colors.fill(given.triple("color"));
  texture.raw = given.boolean("raw") || draft.overrides.noriCompat;
  place(given, texture);
  addTexture(given, texture, draft);
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

}  // namespace laver::xml
