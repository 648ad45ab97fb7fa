#include <fmt/format.h>

#include "scene/dump.h"
#include "scene/properties.h"
#include "scene/schema.h"
#include "scene/textures.h"

namespace laver {

// host/reference/texture/NAME.cpp
namespace reference {
glm::dvec3 checker(const Texture& texture, glm::dvec2 st);
glm::dvec3 bitmap(const Texture& texture, glm::dvec2 st);
}  // namespace reference

namespace {

using xml::Draft;
using xml::Properties;
using enum PropertyType;

/// `rows`, followed by the properties that all textures have.
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
  draft.meshes.back().bsdf.show(draft.textured, std::move(texture));
  draft.meshes.back().textureOffsets[draft.textured] = given.offset();
}

void buildChecker(const Properties& given, std::string_view, Draft& draft) {
  Texture texture{.row = &textures::checker};
  texture.colors = {given.triple("color1"), given.triple("color2")};
  addTexture(given, placed(std::move(texture), given), draft);
}

void buildBitmap(const Properties& given, std::string_view, Draft& draft) {
  if (!given.has("filename")) return;
  Texture texture{.row = &textures::bitmap};
  texture.filename = given.text("filename");
  texture.colors.fill(given.triple("color"));
  texture.raw = given.boolean("raw") || draft.overrides.noriCompat;
  texture = placed(texture, given);
  if (given.rule().type == std::string_view("textmap") &&
      draft.overrides.dialect->textmapMirrored) {
    texture.raw = true;
    texture.scale.x = -texture.scale.x;
    texture.offset.x = -texture.offset.x;
  }
  addTexture(given, std::move(texture), draft);
}

std::string describeChecker(const Texture& texture) {
  return fmt::format("color1 = {}, color2 = {}", dump::triple(texture.colors[0]),
                     dump::triple(texture.colors[1]));
}

std::string describeBitmap(const Texture& texture) {
  return fmt::format("name = \"{}\", color = {}", texture.filename,
                     dump::triple(texture.colors[0]));
}

Form bitmapForm(const char* type) {
  return {.type = type,
          .properties = placed({{.name = "filename",
                                 .type = String,
                                 .required = true,
                                 .meaning = "EXR, PNG or JPEG file"},
                                {.name = "color",
                                 .type = Color,
                                 .start = glm::dvec3(1.0),
                                 .meaning = "factor of the image"},
                                {.name = "raw",
                                 .type = Boolean,
                                 .start = Texture{}.raw,
                                 .meaning = "8-bit and 16-bit values are linear, not sRGB"}}),
          .build = buildBitmap};
}

}  // namespace

namespace textures {

const TextureRow checker{
    .name = "checker",
    .object = "CheckerTexture",
    .forms = {{.type = "checker",
               .properties = placed({{.name = "color1",
                                      .type = Color,
                                      .start = Texture{}.colors[0],
                                      .meaning = "where floor(s) + floor(t) is even"},
                                     {.name = "color2",
                                      .type = Color,
                                      .start = Texture{}.colors[1],
                                      .meaning = "where it is odd"}}),
               .build = buildChecker}},
    .color = reference::checker,
    .describe = describeChecker};

const TextureRow bitmap{
    .name = "bitmap",
    .object = "Texture",
    .forms = {bitmapForm("textmap"), bitmapForm("image_texture"), bitmapForm("bitmap")},
    .picture = true,
    .color = reference::bitmap,
    .describe = describeBitmap};

}  // namespace textures

const Rows<TextureRow>& textureRows() {
  using namespace textures;
  static const Rows<TextureRow> rows = {&checker, &bitmap};
  return rows;
}

}  // namespace laver
