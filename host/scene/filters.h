#pragma once
#include <glm/glm.hpp>
#include <vector>

#include "scene/property.h"
#include "scene/rows.h"

namespace laver {

struct Filter;

namespace reference {
struct FilterTwin;
}

/// A reconstruction filter. Its GLSL is shaders/filter/NAME.glsl, its counterpart in the reference
/// host/reference/filter/NAME.cpp.
struct FilterRow {
  const char* name;                      ///< in scenes and on the command line
  std::vector<const char*> spellings{};  ///< other names in scenes
  const char* object = "";               ///< Nori's class, in the dump
  double radius = 0.0;                   ///< default, pixels
  std::vector<PropertyRow> properties{};
  std::vector<double Filter::*> members{};  ///< of the properties, in their order
  bool narrowForm = false;                  ///< shaders/filter/NAME_narrow.glsl exists
  /// params.filterShape of its GLSL; nullptr if it has none.
  glm::dvec2 (*shape)(const Filter& filter) = nullptr;
  /// The filter on one axis at x pixels from the centre, |x| <= radius, in double precision.
  double (*evaluate)(const Filter& filter, double x) = nullptr;
  const reference::FilterTwin* twin = nullptr;
};

namespace filters {
/// Rows that other code refers to.
extern const FilterRow gaussian, mitchell, tent, box;
}  // namespace filters

const Rows<FilterRow>& filterRows();

/// A separable reconstruction filter; radius and stddev in pixels.
struct Filter {
  const FilterRow* row = &filters::gaussian;
  double radius = 2.0;
  double stddev = 0.5;   ///< gaussian only
  double B = 1.0 / 3.0;  ///< Mitchell only
  double C = 1.0 / 3.0;  ///< Mitchell only
};

/// A filter with default parameters.
Filter filterOf(const FilterRow& row);

}  // namespace laver
