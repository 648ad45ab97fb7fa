#pragma once
#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "image/picture.h"
#include "scene/form.h"
#include "scene/rows.h"

namespace laver {

struct Texture;

/// A type of texture. Its GLSL is shaders/texture/NAME.glsl.
struct TextureRow {
  const char* name;
  const char* object = "";  ///< in the dump
  std::vector<Form> forms{};
  bool picture = false;  ///< it reads an image file
  bool repeats = false;  ///< (s + 2, t) and (s, t + 2) show what (s, t) does
  /// The colour at (s, t) in double precision: host/reference/texture/NAME.cpp.
  glm::dvec3 (*color)(const Texture& texture, glm::dvec2 st) = nullptr;
  /// The mean over the unit square of (s, t).
  glm::dvec3 (*mean)(const Texture& texture) = nullptr;
  /// The part of the dump between the object's brackets, before scale and offset.
  std::string (*describe)(const Texture& texture) = nullptr;
};

namespace textures {
extern const TextureRow checker, bitmap;
}  // namespace textures

const Rows<TextureRow>& textureRows();

/// A colour that varies over a surface with (s, t) = scale * (u, v) + offset.
struct Texture {
  const TextureRow* row = &textures::checker;
  /// Checker: colours where floor(s) and floor(t) are both odd or both even, and elsewhere. Bitmap:
  /// the first is a factor.
  std::array<glm::dvec3, 2> colors{glm::dvec3(0.9), glm::dvec3(0.1)};
  glm::dvec2 scale{1.0};
  glm::dvec2 offset{0.0};
  /// Bitmap: repeated; t points up from the lower edge. Interpolated linearly between pixel
  /// centres, in linear light.
  std::string filename{};  ///< as in the scene
  bool raw = false;        ///< 8-bit and 16-bit values are linear, not encoded as sRGB
  bool red = false;        ///< grey, by the red channel
  std::shared_ptr<const Picture> image{};  ///< null (white) if the integrator needs no materials
};

}  // namespace laver
