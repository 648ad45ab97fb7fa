#pragma once
#include "scene/scene.h"

namespace laver {

/// What a texture shows near a place.
struct TextureBounds {
  double largest;  ///< of any channel
  double change;   ///< of a channel, at most, if the place moves by the shift
};

/// At texture coordinates `uv`, which float arithmetic may move by `shift` on each axis; what it
/// rounds in scaling and interpolating is added. The edges of a checker change nothing: they are
/// decisions. e = 2^-24.
TextureBounds textureBounds(const Texture& texture, glm::dvec2 uv, glm::dvec2 shift);

}  // namespace laver
