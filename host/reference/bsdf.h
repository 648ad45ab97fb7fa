#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string_view>

#include "scene/bsdfs.h"

namespace laver::reference {

/// A point of a surface as BSDFs see it, with the values of the material's properties there.
class BsdfPoint {
 public:
  /// At the texture coordinates `uv`. `along`: a tangent of any length (Surface::tangent).
  BsdfPoint(const Bsdf& bsdf, glm::dvec2 uv, glm::dvec3 unitNormal,
            glm::dvec3 along = {1.0, 0.0, 0.0});

  const Bsdf& bsdf;
  glm::dvec3 normal;  ///< unit shading normal
  glm::dvec3 along;

  /// A colour or a float of the BSDF's row, by name.
  glm::dvec3 color(std::string_view property) const;
  double real(std::string_view property) const;

 private:
  std::array<glm::dvec3, kMostBsdfProperties> values_{};  ///< in the row's order
};

/// A sampled direction and BSDF * |cosine| / density; 0 if the path ends.
struct BsdfSample {
  glm::dvec3 wo;
  glm::dvec3 weight;
};

/// The x axis of the frame about a unit normal: across it, along a tangent of any length. Without
/// one, y is the horizontal direction that Nori takes.
glm::dvec3 frameX(glm::dvec3 normal, glm::dvec3 tangent);

/// Luminance by ITU-R BT.709, with the digits that Nori has.
double luminance(glm::dvec3 color);

/// Fresnel reflectance of unpolarised light at a dielectric (Born and Wolf, "Principles of Optics",
/// 1.5). `cosine` is relative to the normal, positive on the side with index `outside`.
double fresnel(double cosine, double outside, double inside);

}  // namespace laver::reference
