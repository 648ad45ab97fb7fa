#include "support/bsdf_cases.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/bsdf.h"

namespace laver::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Indices of refraction keep their values.
bool isReflectance(const std::string& name) {
  return name != "eta" && name != "k" && name != "intIOR" && name != "intK";
}

Bsdf coloured(const BsdfRow& row) {
  Bsdf bsdf{.row = &row};
  double scale = 1.0;
  for (const PropertyRow* property : propertiesOf(row, PropertyType::Color)) {
    if (!isReflectance(property->name)) continue;
    bsdf.set(property->name, glm::dvec3(0.25, 0.5, 0.75) * scale);
    scale *= 0.5;
  }
  return bsdf;
}

Texture checker(glm::dvec3 color1, glm::dvec3 color2) {
  Texture texture;
  texture.colors = {color1, color2};
  texture.scale = {5.0, 3.0};
  texture.offset = {0.25, 0.125};
  return texture;
}

Bsdf textured(Bsdf bsdf) {
  for (const PropertyRow& property : bsdf.row->properties) {
    if (property.type == PropertyType::Color) {
      const glm::dvec3 color = bsdf.color(property.name);
      bsdf.show(property.name, checker(color, 0.5 * color));
    } else if (property.type == PropertyType::Float) {
      const glm::dvec3 number(bsdf.real(property.name));
      bsdf.show(property.name, checker(number, 0.75 * number));
    }
  }
  return bsdf;
}

/// Further values of a BSDF's numbers.
std::vector<Values> variantsOf(const std::string& name) {
  // Without a diffuse part, so that the samples are those of the facets.
  if (name == "microfacet") return {{{"alpha", 0.4}}, {{"alpha", 0.4}, {"kd", glm::dvec3(0.0)}}};
  if (name == "disney")
    return {{{"metallic", 1.0}, {"roughness", 0.4}},
            {{"clearcoat", 1.0}, {"clearcoatGloss", 0.3}, {"specularTint", 0.5}},
            {{"metallic", 1.0}, {"roughness", 0.6}, {"anisotropic", 0.7}},
            {{"subsurface", 0.6}, {"sheen", 0.5}, {"sheenTint", 0.5}, {"roughness", 0.8}}};
  if (name == "roughconductor") return {{{"alpha", 0.4}}};
  if (name == "microfacet_dielectric") return {{{"alpha", 0.4}}, {{"intIOR", 0.8}, {"alpha", 0.2}}};
  if (name == "phong") return {{{"shininess", 40.0}}};
  // A coat that reflects most.
  if (name == "roughsubstrate") return {{{"alpha", 0.4}}, {{"alpha", 0.4}, {"intIOR", 20.0}}};
  return {};
}

double valueOf(const Bsdf& bsdf, const char* name, double otherwise) {
  for (const PropertyRow& property : bsdf.row->properties)
    if (property.name == std::string_view(name)) return bsdf.real(name);
  return otherwise;
}

/// Numbers of directions by cells of equal solid angle over the sphere.
struct Cells {
  static constexpr int kRows = 16, kColumns = 8;
  std::array<double, static_cast<std::size_t>(kRows* kColumns)> of{};

  double& at(int row, int column) { return of[static_cast<std::size_t>(row * kColumns + column)]; }
};

Cells seen(const std::vector<glm::dvec3>& samples) {
  Cells cells;
  for (const glm::dvec3& d : samples) {
    if (d == glm::dvec3(0.0)) continue;
    const double turn = std::atan2(d.y, d.x) / (2.0 * kPi) + 0.5;
    const int row = static_cast<int>((d.z + 1.0) / 2.0 * Cells::kRows);
    ++cells.at(std::clamp(row, 0, Cells::kRows - 1),
               std::min(static_cast<int>(turn * Cells::kColumns), Cells::kColumns - 1));
  }
  return cells;
}

/// By the midpoint rule.
Cells expected(const Bsdf& bsdf, glm::dvec2 uv, glm::dvec3 wi, double samples) {
  constexpr int kSteps = 24;  // of a cell, a side: some ten across the narrowest lobe
  const reference::BsdfPoint point(bsdf, uv, {0.0, 0.0, 1.0});
  Cells cells;
  constexpr int kRows = Cells::kRows * kSteps, kColumns = Cells::kColumns * kSteps;
  for (int row = bsdf.row->transmissive ? 0 : kRows / 2; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const double z = 2.0 * (row + 0.5) / kRows - 1.0;
      const double phi = ((column + 0.5) / kColumns - 0.5) * 2.0 * kPi;
      cells.at(row / kSteps, column / kSteps) +=
          bsdf.row->pdf(point, wi, directionAt(std::acos(z), phi)) * samples * 4.0 * kPi /
          (static_cast<double>(kRows) * kColumns);
    }
  return cells;
}

}  // namespace

std::vector<BsdfCase> bsdfCases() {
  std::vector<BsdfCase> cases;
  for (const BsdfRow* row : bsdfRows()) {
    const std::string name = row->name;
    cases.push_back({name, coloured(*row)});
    int number = 2;
    for (const Values& values : variantsOf(name)) {
      cases.push_back({name + "_" + std::to_string(number++), coloured(*row)});
      for (const NamedValue& value : values) cases.back().bsdf.set(value.name, value.value);
    }
    if (!row->properties.empty())
      cases.push_back({name + "_textured", textured(cases.back().bsdf)});
  }
  return cases;
}

double narrowestLobe(const Bsdf& bsdf) {
  const double alpha = valueOf(bsdf, "alpha", 1.0), roughness = valueOf(bsdf, "roughness", 1.0);
  double width = std::min(alpha, roughness * roughness);
  if (valueOf(bsdf, "clearcoat", 0.0) > 0.0)
    width = std::min(width, std::lerp(0.1, 0.001, valueOf(bsdf, "clearcoatGloss", 0.0)));
  width = std::min(width, 1.0 / std::sqrt(valueOf(bsdf, "shininess", 0.0) + 1.0));
  return bsdf.textures.empty() ? width : 0.5 * width;
}

glm::dvec3 directionAt(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double deviateOf(const Bsdf& bsdf, glm::dvec2 uv, glm::dvec3 wi,
                 const std::vector<glm::dvec3>& samples) {
  const Cells counted = seen(samples);
  const Cells wanted = expected(bsdf, uv, wi, static_cast<double>(samples.size()));
  // Cells that expect few directions are one.
  double chi = 0.0, degrees = 0.0, fewCounted = 0.0, fewWanted = 0.0;
  const auto add = [&](double count, double want) {
    chi += (count - want) * (count - want) / want;
    ++degrees;
  };
  for (std::size_t i = 0; i < counted.of.size(); ++i) {
    if (wanted.of[i] >= 10.0) {
      add(counted.of[i], wanted.of[i]);
    } else {
      fewCounted += counted.of[i];
      fewWanted += wanted.of[i];
    }
  }
  if (fewCounted + fewWanted > 0.0) add(fewCounted, std::max(fewWanted, 1.0));
  // Wilson and Hilferty, "The Distribution of Chi-Square", 1931. The total is not fixed, since
  // directions of weight 0 are left out.
  const double spread = 2.0 / (9.0 * degrees);
  return (std::cbrt(chi / degrees) - (1.0 - spread)) / std::sqrt(spread);
}

}  // namespace laver::test
