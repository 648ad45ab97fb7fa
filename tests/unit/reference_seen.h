#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "reference/reference.h"
#include "unit/reference_scenes.h"

namespace laver::test {

inline void expectNear(glm::dvec3 a, glm::dvec3 b, double relative = 1e-14) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], relative * std::abs(b[i])) << i;
}

/// Radiance of a point of the scene as seen by its downCamera().
inline glm::dvec3 seenAt(const Scene& scene, glm::dvec3 point) {
  return Reference(scene).radiance(filmOf(scene.camera, point));
}

}  // namespace laver::test
