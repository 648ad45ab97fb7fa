#pragma once
#include <string>

#include "random/draw.h"
#include "random/kinds.h"

namespace laver::test {

/// A point of a mesh, or the origin of an empty one.
glm::dvec3 pointOn(const Mesh& mesh, Draw& draw);

/// Lights in odd places, a background, a lamp, and what the integrator takes: of a strength that
/// unit surfaces around the origin show.
void addLighting(const Kind& kind, Scene& scene, Draw& draw, std::string& traits);

}  // namespace laver::test
