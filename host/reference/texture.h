#pragma once
#include <glm/glm.hpp>

#include "scene/bsdfs.h"

namespace laver::reference {

struct Surface;

/// What a texture shows at texture coordinates.
glm::dvec3 colorOf(const Texture& texture, glm::dvec2 uv);

/// The shading normal as BSDFs see it: bent by the material's normal map, if it has one.
glm::dvec3 bsdfNormal(const Surface& surface);

/// The first colour of a material at texture coordinates; white where it has none.
glm::dvec3 albedoAt(const Bsdf& bsdf, glm::dvec2 uv);

/// Linear light of the pixel in column x, row y, counted from the upper edge.
glm::dvec3 pixelAt(const Picture& picture, bool raw, int x, int y);

/// Bilinear interpolation of an image at x, y in pixels, in linear light: weight 1 - |distance| on
/// each axis for the pixels whose centres are less than 1 away. The image repeats beyond the left
/// and right border; beyond the others it repeats or continues its border pixel.
glm::dvec3 interpolated(const Picture& picture, bool raw, double x, double y, bool repeats);

}  // namespace laver::reference
