#include "scene/filters.h"

#include <algorithm>
#include <cmath>

namespace laver {

// host/reference/filter/NAME.cpp
namespace reference {
extern const FilterTwin gaussian, mitchell, tent, box;
}

namespace {

PropertyRow radiusRow() {
  return {.name = "radius",
          .type = PropertyType::Float,
          .start = Filter{}.radius,
          .range = moreThan(0.0),
          .unit = "pixels",
          .meaning = "samples farther than this on either axis have no weight"};
}

// A Gaussian, lowered to reach 0 at the radius.
double gaussianAt(const Filter& f, double x) {
  const double alpha = -1.0 / (2.0 * f.stddev * f.stddev);
  return std::max(0.0, std::exp(alpha * x * x) - std::exp(alpha * f.radius * f.radius));
}

// Mitchell and Netravali, "Reconstruction Filters in Computer Graphics", 1988, equation 8, with its
// support of 2 scaled to the radius. The outer piece is factored at its double root.
double mitchellAt(const Filter& f, double x) {
  const double s = 2.0 * std::abs(x) / f.radius, y = 2.0 - s;
  if (s < 1.0)
    return (((12.0 - 9.0 * f.B - 6.0 * f.C) * s + (-18.0 + 12.0 * f.B + 6.0 * f.C)) * s * s +
            (6.0 - 2.0 * f.B)) /
           6.0;
  return s < 2.0 ? y * y * ((f.B + 6.0 * f.C) * y - 6.0 * f.C) / 6.0 : 0.0;
}

glm::dvec2 gaussianShape(const Filter& f) {
  const double alpha = -1.0 / (2.0 * f.stddev * f.stddev);
  return {alpha, std::exp(alpha * f.radius * f.radius)};
}

glm::dvec2 mitchellShape(const Filter& f) { return {f.B, f.C}; }

double tentAt(const Filter& f, double x) { return std::max(0.0, 1.0 - std::abs(x) / f.radius); }

double boxAt(const Filter&, double) { return 1.0; }

}  // namespace

namespace filters {

const FilterRow gaussian{.name = "gaussian",
                         .object = "GaussianFilter",
                         .radius = Filter{}.radius,
                         .properties = {radiusRow(),
                                        {.name = "stddev",
                                         .type = PropertyType::Float,
                                         .start = Filter{}.stddev,
                                         .range = moreThan(0.0),
                                         .unit = "pixels",
                                         .meaning = "standard deviation"}},
                         .members = {&Filter::radius, &Filter::stddev},
                         .narrowForm = true,
                         .shape = gaussianShape,
                         .evaluate = gaussianAt,
                         .twin = &reference::gaussian};

const FilterRow mitchell{.name = "mitchell",
                         .object = "MitchellNetravaliFilter",
                         .radius = Filter{}.radius,
                         .properties = {radiusRow(),
                                        {.name = "B",
                                         .type = PropertyType::Float,
                                         .start = Filter{}.B,
                                         .meaning = "Mitchell and Netravali's B"},
                                        {.name = "C",
                                         .type = PropertyType::Float,
                                         .start = Filter{}.C,
                                         .meaning = "Mitchell and Netravali's C"}},
                         .members = {&Filter::radius, &Filter::B, &Filter::C},
                         .shape = mitchellShape,
                         .evaluate = mitchellAt,
                         .twin = &reference::mitchell};

// Nori's tent and box have fixed radii.
const FilterRow tent{.name = "tent",
                     .object = "TentFilter",
                     .radius = 1.0,
                     .evaluate = tentAt,
                     .twin = &reference::tent};

const FilterRow box{.name = "box",
                    .object = "BoxFilter",
                    .radius = 0.5,
                    .evaluate = boxAt,
                    .twin = &reference::box};

}  // namespace filters

const Rows<FilterRow>& filterRows() {
  using namespace filters;
  static const Rows<FilterRow> rows = {&gaussian, &mitchell, &tent, &box};
  return rows;
}

Filter filterOf(const FilterRow& row) { return {.row = &row, .radius = row.radius}; }

}  // namespace laver
