#include "reference/bsdf.h"

#include <cmath>
#include <utility>

#include "reference/texture.h"

namespace laver::reference {

namespace {

std::size_t placeOf(const BsdfRow& row, std::string_view property) {
  std::size_t i = 0;
  while (row.properties.at(i).name != property) ++i;
  return i;
}

}  // namespace

double luminance(glm::dvec3 color) { return glm::dot(color, {0.212671, 0.715160, 0.072169}); }

// A texture that stands for a number shows its luminance, as in Nori.
BsdfPoint::BsdfPoint(const Bsdf& b, glm::dvec2 uv, glm::dvec3 unitNormal, glm::dvec3 tangent)
    : bsdf(b), normal(unitNormal), along(tangent) {
  for (std::size_t i = 0; i < b.row->properties.size(); ++i) {
    const PropertyRow& property = b.row->properties[i];
    const bool number = property.type == PropertyType::Float;
    if (const Texture* texture = b.texture(property.name)) {
      const glm::dvec3 shown = colorOf(*texture, uv);
      values_.at(i) = number ? glm::dvec3(luminance(shown)) : shown;
    } else if (number) {
      values_.at(i) = glm::dvec3(b.real(property.name));
    } else if (property.type == PropertyType::Color) {
      values_.at(i) = b.color(property.name);
    }
  }
}

glm::dvec3 BsdfPoint::color(std::string_view property) const {
  return values_[placeOf(*bsdf.row, property)];
}

double BsdfPoint::real(std::string_view property) const { return color(property).x; }

glm::dvec3 frameX(glm::dvec3 n, glm::dvec3 tangent) {
  glm::dvec3 x = tangent - n * glm::dot(n, tangent);
  if (!(glm::dot(x, x) > 0.0)) {
    const bool tilted = std::abs(n.x) > std::abs(n.y);
    x = glm::cross(tilted ? glm::dvec3(n.z, 0.0, -n.x) : glm::dvec3(0.0, n.z, -n.y), n);
  }
  return glm::normalize(x);
}

double fresnel(double cosine, double outside, double inside) {
  if (outside == inside) return 0.0;
  if (cosine < 0.0) std::swap(outside, inside);
  const double eta = outside / inside, c1 = std::abs(cosine);
  const double sine2 = eta * eta * (1.0 - c1 * c1);
  if (sine2 > 1.0) return 1.0;
  const double c2 = std::sqrt(1.0 - sine2);
  const double parallel = (outside * c2 - inside * c1) / (outside * c2 + inside * c1);
  const double perpendicular = (outside * c1 - inside * c2) / (outside * c1 + inside * c2);
  return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

}  // namespace laver::reference
