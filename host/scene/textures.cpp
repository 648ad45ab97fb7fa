#include "scene/textures.h"

#include <fmt/format.h>

#include "scene/dump.h"
#include "scene/schema.h"
#include "scene/texture_forms.h"

namespace laver {

// host/reference/texture/NAME.cpp
namespace reference {
glm::dvec3 checker(const Texture& texture, glm::dvec2 st);
glm::dvec3 constant(const Texture& texture, glm::dvec2 st);
glm::dvec3 noise(const Texture& texture, glm::dvec2 st);
glm::dvec3 stripes(const Texture& texture, glm::dvec2 st);
glm::dvec3 uv(const Texture& texture, glm::dvec2 st);
}  // namespace reference

namespace xml {

using enum PropertyType;

std::vector<PropertyRow> placed(std::vector<PropertyRow> rows) {
  const Texture texture;
  const PropertyRow all[] = {
      {.name = "scalex", .type = Float, .start = texture.scale.x, .meaning = "factor of u"},
      {.name = "scaley", .type = Float, .start = texture.scale.y, .meaning = "factor of v"},
      {.name = "offsetx",
       .type = Float,
       .start = texture.offset.x,
       .meaning = "added to the scaled u"},
      {.name = "offsety",
       .type = Float,
       .start = texture.offset.y,
       .meaning = "added to the scaled v"},
  };
  rows.insert(rows.end(), std::begin(all), std::end(all));
  return rows;
}

Texture placed(Texture texture, const Properties& given) {
  texture.scale = {given.real("scalex"), given.real("scaley")};
  texture.offset = {given.real("offsetx"), given.real("offsety")};
  return texture;
}

void addTexture(const Properties& given, Texture texture, Draft& draft) {
  if (draft.meshes.empty()) return;
  MeshDraft& mesh = draft.meshes.back();
  if (draft.texturedLight && mesh.light) {
    mesh.light->texture = std::make_shared<Texture>(std::move(texture));
    mesh.radianceOffset = given.offset();
  } else if (!draft.texturedLight) {
    texture.raw |= draft.textured == kNormalMap;
    mesh.bsdf.show(draft.textured, std::move(texture));
    mesh.textureOffsets[draft.textured] = given.offset();
  }
}

PropertyRow pairOf(const char* name, PropertyType type, double start, const char* meaning) {
  return {.name = name,
          .type = type,
          .start = glm::dvec3(start, start, 0.0),
          .meaning = meaning,
          .pair = true};
}

glm::dvec2 pairIn(const Properties& given, std::string_view name) {
  return glm::dvec2(given.triple(name));
}

glm::dvec2 inverseScale(const Properties& given) {
  const glm::dvec2 scale = pairIn(given, "scale");
  if (scale.x == 0.0 || scale.y == 0.0) given.error("scale", "scale must not be 0");
  return 1.0 / scale;
}

namespace {

PropertyRow color(const char* name, glm::dvec3 start, const char* meaning) {
  return {.name = name, .type = Color, .start = start, .meaning = meaning};
}

PropertyRow real(const char* name, double start, const char* meaning) {
  return {.name = name, .type = Float, .start = start, .meaning = meaning};
}

PropertyRow cell() { return pairOf("scale", Vector, 1.0, "size of a field in u and v"); }
PropertyRow delta() { return pairOf("delta", Point, 0.0, "fields by which they are moved"); }

/// (s, t) = uv / scale - delta.
Texture inCells(Texture texture, const Properties& given) {
  texture.scale = inverseScale(given);
  texture.offset = -pairIn(given, "delta");
  return texture;
}

void buildChecker(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::checker};
  texture.colors = {given.triple("color1"), given.triple("color2")};
  // One property for both colours, in a course's own.
  const bool both = given.wasGiven(given.find("color"));
  if (both && !given.wasGiven(given.find("color1"))) texture.colors[0] = given.triple("color");
  if (both && !given.wasGiven(given.find("color2"))) texture.colors[1] = given.triple("color");
  addTexture(given, placed(std::move(texture), given), draft);
}

void buildCheckerboard(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::checker};
  texture.colors = {given.triple("value1"), given.triple("value2")};
  addTexture(given, inCells(std::move(texture), given), draft);
}

void buildFloatCheckerboard(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::checker};
  texture.colors = {glm::dvec3(given.real("value1")), glm::dvec3(given.real("value2"))};
  addTexture(given, inCells(std::move(texture), given), draft);
}

void buildConstant(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::constant};
  texture.colors.fill(given.triple("value"));
  addTexture(given, std::move(texture), draft);
}

void buildFloatConstant(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::constant};
  texture.colors.fill(glm::dvec3(given.real("value")));
  addTexture(given, std::move(texture), draft);
}

void buildStripes(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::stripes};
  texture.colors = {given.triple("color1"), given.triple("color2")};
  addTexture(given, inCells(std::move(texture), given), draft);
}

void buildFlat(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::constant};
  texture.colors.fill({0.5, 0.5, 1.0});
  addTexture(given, std::move(texture), draft);
}

PropertyRow whole(const char* name, std::int64_t start, const char* meaning) {
  return {.name = name, .type = Integer, .start = start, .meaning = meaning};
}

void buildNoise(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::noise};
  texture.scale = {static_cast<double>(given.integer("width", std::nullopt)),
                   static_cast<double>(given.integer("height", std::nullopt))};
  addTexture(given, std::move(texture), draft);
}

void buildUv(const Properties& given, std::string_view, Draft& draft) {
  addTexture(given, {.row = &textures::uv}, draft);
}

glm::dvec3 meanColor(const Texture& texture) {
  return 0.5 * (texture.colors[0] + texture.colors[1]);
}
glm::dvec3 onlyColor(const Texture& texture) { return texture.colors[0]; }
glm::dvec3 grey(const Texture&) { return glm::dvec3(0.5); }
glm::dvec3 meanUv(const Texture&) { return {0.5, 0.5, 0.0}; }

std::string describeColors(const Texture& texture) {
  return fmt::format("color1 = {}, color2 = {}", dump::triple(texture.colors[0]),
                     dump::triple(texture.colors[1]));
}

std::string describeColor(const Texture& texture) {
  return fmt::format("value = {}", dump::triple(texture.colors[0]));
}

std::string describeNoise(const Texture&) { return "nine octaves"; }
std::string describeUv(const Texture&) { return "(u, v, 0)"; }

const std::vector<Form> kCheckers = {
    {.type = "checker",
     .properties = placed(
         {color("color1", Texture{}.colors[0], "where floor(s) + floor(t) is even"),
          color("color2", Texture{}.colors[1], "where it is odd"),
          color("color", Texture{}.colors[0], "both, where color1 and color2 are not given")}),
     .build = buildChecker},
    {.type = "checkerboard_color",
     .properties = {color("value1", glm::dvec3(0.0), "where floor(s) + floor(t) is even"),
                    color("value2", glm::dvec3(1.0), "where it is odd"), cell(), delta()},
     .build = buildCheckerboard},
    {.type = "checkerboard_float",
     .properties = {real("value1", 0.0, "where floor(s) + floor(t) is even"),
                    real("value2", 1.0, "where it is odd"), cell(), delta()},
     .build = buildFloatCheckerboard}};

}  // namespace
}  // namespace xml

namespace textures {

const TextureRow checker{.name = "checker",
                         .object = "CheckerTexture",
                         .forms = xml::kCheckers,
                         .repeats = true,
                         .color = reference::checker,
                         .mean = xml::meanColor,
                         .describe = xml::describeColors};

const TextureRow constant{
    .name = "constant",
    .object = "ConstantTexture",
    .forms = {{.type = "constant_color",
               .properties = {xml::color("value", glm::dvec3(0.0), "everywhere")},
               .build = xml::buildConstant},
              {.type = "constant_float",
               .properties = {xml::real("value", 0.0, "everywhere")},
               .build = xml::buildFloatConstant},
              {.type = "normaltexture", .build = xml::buildFlat}},
    .color = reference::constant,
    .mean = xml::onlyColor,
    .describe = xml::describeColor};

const TextureRow stripes{
    .name = "stripes",
    .object = "StripesTexture",
    .forms = {{.type = "proceduraltexture",
               .properties = {xml::color("color1", glm::dvec3(0.0), "where floor(s) is even"),
                              xml::color("color2", glm::dvec3(1.0), "where it is odd"), xml::cell(),
                              xml::delta()},
               .build = xml::buildStripes}},
    .color = reference::stripes,
    .mean = xml::meanColor,
    .describe = xml::describeColors};

const TextureRow noise{
    .name = "noise",
    .object = "NoiseTexture",
    .forms = {{.type = "perlintexture",
               .properties = {xml::whole("width", 512, "cells of the finest octave along u"),
                              xml::whole("height", 512, "cells of the finest octave along v"),
                              xml::whole("levels", 9, "not used: there are nine octaves")},
               .build = xml::buildNoise}},
    .color = reference::noise,
    .mean = xml::grey,
    .describe = xml::describeNoise};

const TextureRow uv{.name = "uv",
                    .object = "UvTexture",
                    .forms = {{.type = "uvtexture", .build = xml::buildUv}},
                    .color = reference::uv,
                    .mean = xml::meanUv,
                    .describe = xml::describeUv};

}  // namespace textures

const Rows<TextureRow>& textureRows() {
  using namespace textures;
  static const Rows<TextureRow> rows = {&checker, &constant, &stripes, &noise,
                                        &uv,      &bitmap,   &nearest};
  return rows;
}

}  // namespace laver
