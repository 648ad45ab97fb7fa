#pragma once
#include <array>
#include <glm/glm.hpp>
#include <string_view>

#include "scene/bsdfs.h"

namespace laver::reference {

/// A point of a surface as BSDFs see it, with the values of the material's properties there.
class BsdfPoint {
 public:
  /// At the texture coordinates `uv`.
  BsdfPoint(const Bsdf& bsdf, glm::dvec2 uv, glm::dvec3 unitNormal);

  const Bsdf& bsdf;
  glm::dvec3 normal;  ///< unit shading normal

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

/// Luminance by ITU-R BT.709, with the digits that Nori has.
double luminance(glm::dvec3 color);

/// Fresnel reflectance of unpolarised light at a dielectric (Born and Wolf, "Principles of Optics",
/// 1.5). `cosine` is relative to the normal, positive on the side with index `outside`.
double fresnel(double cosine, double outside, double inside);

}  // namespace laver::reference
