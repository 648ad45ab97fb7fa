#pragma once
#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "image/picture.h"

namespace laver {

/// A colour that varies over a surface with (s, t) = scale * (u, v) + offset.
struct Texture {
  enum class Kind { Checker, Image };
  Kind kind = Kind::Checker;
  /// Checker: where floor(s) and floor(t) are both odd or both even, and elsewhere. Image: the
  /// first is a factor.
  std::array<glm::dvec3, 2> colors{glm::dvec3(0.9), glm::dvec3(0.1)};
  glm::dvec2 scale{1.0};
  glm::dvec2 offset{0.0};
  /// Image, repeated; t points up, from the lower edge. Interpolated linearly between the centres
  /// of its pixels, once these are linear light.
  std::string filename;  ///< as the scene gives it
  bool raw = false;      ///< 8-bit and 16-bit values are linear, not encoded as sRGB
  std::shared_ptr<const Picture> image;  ///< none where the integrator needs no material: white
};

/// What rays that meet nothing see. Of an image, in the space that toWorld takes to the world, the
/// rows go from +y to -y and the columns from -z over +x, +z and -x, as in Mitsuba.
struct Environment {
  glm::dvec3 radiance{1.0};  ///< of all directions, or an image's factor
  glm::dmat4 toWorld{1.0};   ///< its linear part counts
  std::string filename;      ///< empty: no image
  bool raw = false;
  std::shared_ptr<const Picture> image;  ///< none where the integrator shows no background
};

}  // namespace laver
