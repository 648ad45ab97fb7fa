#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "scene/scene.h"

namespace laver::test {

/// A closed mesh around `centre` whose vertices are at distances of 1 ± `bump`, in rings of
/// `segments` from pole to pole. With corners less than 0.4 apart in angle and bumps of 0.1, no
/// point of it is nearer to the centre than 0.8.
inline Mesh bumpySphere(unsigned rings, unsigned segments, double bump, glm::dvec3 centre) {
  Mesh mesh;
  const auto add = [&](double theta, double phi) {
    const double r = 1.0 + bump * std::sin(20.0 * theta) * std::cos(16.0 * phi);
    mesh.positions.push_back(centre + r * glm::dvec3(std::sin(theta) * std::cos(phi),
                                                     std::sin(theta) * std::sin(phi),
                                                     std::cos(theta)));
  };
  add(0.0, 0.0);
  for (unsigned i = 1; i < rings; ++i)
    for (unsigned j = 0; j < segments; ++j)
      add(std::numbers::pi * i / rings, 2.0 * std::numbers::pi * j / segments);
  add(std::numbers::pi, 0.0);
  const auto at = [&](unsigned ring, unsigned j) {
    return 1 + (ring - 1) * segments + j % segments;
  };
  const unsigned last = 1 + (rings - 1) * segments;
  for (unsigned j = 0; j < segments; ++j) {
    mesh.triangles.emplace_back(0, at(1, j), at(1, j + 1));
    for (unsigned i = 1; i + 1 < rings; ++i) {
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
    mesh.triangles.emplace_back(last, at(rings - 1, j + 1), at(rings - 1, j));
  }
  return mesh;
}

}  // namespace laver::test
