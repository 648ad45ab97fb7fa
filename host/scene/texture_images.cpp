// The rows of textures that show a file.
#include <fmt/format.h>

#include "scene/dump.h"
#include "scene/schema.h"
#include "scene/texture_forms.h"

namespace laver {

// host/reference/texture/NAME.cpp
namespace reference {
glm::dvec3 bitmap(const Texture& texture, glm::dvec2 st);
glm::dvec3 nearest(const Texture& texture, glm::dvec2 st);
}  // namespace reference

namespace xml {
namespace {

using enum PropertyType;

PropertyRow file(const char* name) {
  return {.name = name,
          .type = String,
          .required = true,
          .meaning = "EXR, PNG or JPEG, beside the scene"};
}

PropertyRow real(const char* name, double start, const char* meaning) {
  return {.name = name, .type = Float, .start = start, .meaning = meaning};
}

PropertyRow boolean(const char* name, bool start, const char* meaning) {
  return {.name = name, .type = Boolean, .start = start, .meaning = meaning};
}

PropertyRow factor() {
  return {
      .name = "color", .type = Color, .start = glm::dvec3(1.0), .meaning = "factor of the picture"};
}

PropertyRow raw() {
  return boolean("raw", Texture{}.raw, "8-bit and 16-bit values are linear, not sRGB");
}

/// The texture of a file; none if it is not named.
std::optional<Texture> imageOf(const Properties& given, const char* name, const Draft& draft) {
  if (!given.has(name)) return std::nullopt;
  Texture texture{.row = &textures::bitmap};
  texture.filename = given.text(name);
  texture.colors.fill(glm::dvec3(1.0));
  texture.raw = draft.overrides.noriCompat;
  return texture;
}

void buildBitmap(const Properties& given, std::string_view, Draft& draft) {
  std::optional<Texture> texture = imageOf(given, "filename", draft);
  if (!texture) return;
  texture->colors.fill(given.triple("color"));
  texture->raw |= given.boolean("raw");
  *texture = placed(*texture, given);
  if (given.rule().type == std::string_view("textmap") &&
      draft.overrides.dialect->textmapMirrored) {
    texture->raw = true;
    texture->scale.x = -texture->scale.x;
    texture->offset.x = -texture->offset.x;
  }
  addTexture(given, *texture, draft);
}

void buildImageTexture(const Properties& given, std::string_view, Draft& draft) {
  std::optional<Texture> texture = imageOf(given, "filename", draft);
  if (!texture) return;
  texture->colors.fill(given.triple("color"));
  texture->raw |= given.boolean("raw") || !given.boolean("linear_rgb");
  *texture = placed(*texture, given);
  const glm::dvec2 scale = pairIn(given, "scale");
  if (scale != glm::dvec2(1.0))
    given.warning("scale", "scale multiplies u and v; in some courses it divides them");
  texture->scale *= scale;
  texture->offset += pairIn(given, "shift");
  addTexture(given, *texture, draft);
}

/// A linear picture by whose `scale` u and v are divided.
std::optional<Texture> dividedImage(const Properties& given, const char* name, const Draft& draft) {
  std::optional<Texture> texture = imageOf(given, name, draft);
  if (!texture) return texture;
  texture->raw = true;
  texture->scale = inverseScale(given);
  return texture;
}

void buildFloatImage(const Properties& given, std::string_view, Draft& draft) {
  std::optional<Texture> texture = dividedImage(given, "filename", draft);
  if (!texture) return;
  texture->red = true;
  addTexture(given, *texture, draft);
}

// Rows count from the top, and so does v.
void buildNearest(const Properties& given, std::string_view, Draft& draft) {
  std::optional<Texture> texture = dividedImage(given, "fileName", draft);
  if (!texture) return;
  texture->row = &textures::nearest;
  addTexture(given, *texture, draft);
}

void buildNormalImage(const Properties& given, std::string_view, Draft& draft) {
  if (const auto texture = dividedImage(given, "filename", draft))
    addTexture(given, *texture, draft);
}

void buildNormalMap(const Properties& given, std::string_view, Draft& draft) {
  std::optional<Texture> texture = imageOf(given, "filename", draft);
  if (!texture) return;
  texture->raw = true;
  texture->scale = pairIn(given, "scale");
  texture->offset = pairIn(given, "shift");
  addTexture(given, *texture, draft);
}

void buildPng(const Properties& given, std::string_view, Draft& draft) {
  std::optional<Texture> texture = imageOf(given, "filename", draft);
  if (!texture) return;
  texture->raw |= !given.boolean("sRGB");
  texture->colors.fill(glm::dvec3(given.real("intensity")));
  texture->scale = {given.real("scaleU"), given.real("scaleV")};
  texture->offset = {given.real("offsetU"), given.real("offsetV")};
  addTexture(given, *texture, draft);
}

Form bitmapForm(const char* type) {
  return {.type = type,
          .properties = placed({file("filename"), factor(), raw()}),
          .build = buildBitmap};
}

Form imageTexture() {
  return {.type = "image_texture",
          .properties = placed(
              {file("filename"), factor(), raw(), pairOf("scale", Vector, 1.0, "factor of u and v"),
               pairOf("shift", Point, 0.0, "added to the scaled u and v"),
               boolean("linear_rgb", true, "8-bit and 16-bit values are decoded from sRGB")}),
          .build = buildImageTexture};
}

Form floatImage() {
  return {
      .type = "image_texture_float",
      .properties = {file("filename"), pairOf("scale", Vector, 1.0, "u and v are divided by it")},
      .build = buildFloatImage};
}

Form normalImage() {
  return {
      .type = "image_normal",
      .properties = {file("filename"), pairOf("scale", Vector, 1.0, "u and v are divided by it")},
      .build = buildNormalImage};
}

Form normalMap() {
  return {.type = "normal_map",
          .properties = {file("filename"), pairOf("scale", Vector, 1.0, "factor of u and v"),
                         pairOf("shift", Point, 0.0, "added to the scaled u and v")},
          .build = buildNormalMap};
}

Form pngTexture() {
  return {.type = "png_texture",
          .properties = {file("filename"),
                         boolean("sRGB", true, "8-bit and 16-bit values are decoded from sRGB"),
                         real("intensity", 1.0, "factor of the picture"),
                         real("scaleU", 1.0, "factor of u"), real("scaleV", 1.0, "factor of v"),
                         real("offsetU", 0.0, "added to the scaled u"),
                         real("offsetV", 0.0, "added to the scaled v")},
          .build = buildPng};
}

double linearOf(const Texture& texture, std::uint8_t byte) {
  return texture.raw ? byte / 255.0 : linearOfSrgb(byte / 255.0);
}

glm::dvec3 meanOfPicture(const Texture& texture) {
  if (!texture.image) return texture.colors[0];
  glm::dvec3 sum(0.0);
  double count = 0.0;
  const auto add = [&](const glm::dvec3& pixel) {
    sum += texture.red ? glm::dvec3(pixel.r) : pixel;
    count += 1.0;
  };
  if (const auto* bitmap = std::get_if<Bitmap>(texture.image.get())) {
    for (const Rgb8& p : bitmap->pixels)
      add({linearOf(texture, p[0]), linearOf(texture, p[1]), linearOf(texture, p[2])});
  } else {
    const auto& values = std::get<Image>(*texture.image).pixels;
    for (std::size_t i = 0; i < values.size(); i += 3)
      add({double{values[i]}, double{values[i + 1]}, double{values[i + 2]}});
  }
  return texture.colors[0] * sum / count;
}

std::string describeImage(const Texture& texture) {
  return fmt::format("name = \"{}\", color = {}", texture.filename,
                     dump::triple(texture.colors[0]));
}

}  // namespace
}  // namespace xml

namespace textures {

const TextureRow bitmap{
    .name = "bitmap",
    .object = "Texture",
    .forms = {xml::bitmapForm("textmap"), xml::imageTexture(), xml::bitmapForm("bitmap"),
              xml::floatImage(), xml::pngTexture(), xml::normalImage(), xml::normalMap()},
    .picture = true,
    .repeats = true,
    .color = reference::bitmap,
    .mean = xml::meanOfPicture,
    .describe = xml::describeImage};

const TextureRow nearest{
    .name = "nearest",
    .object = "NearestTexture",
    .forms = {{.type = "imagetexture",
               .properties = {xml::file("fileName"), xml::pairOf("scale", PropertyType::Vector, 1.0,
                                                                 "u and v are divided by it")},
               .build = xml::buildNearest}},
    .picture = true,
    .repeats = true,
    .color = reference::nearest,
    .mean = xml::meanOfPicture,
    .describe = xml::describeImage};

}  // namespace textures
}  // namespace laver
