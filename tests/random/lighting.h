#pragma once
#include <string>

#include "random/draw.h"
#include "random/kinds.h"

namespace laver::test {

/// With random colours, scale and offset.
Texture randomTexture(const TextureRow& row, Draw& draw);

/// A point of a mesh, or the origin of an empty one. No corner: a light there is blocked or not in
/// cones as narrow as the triangles, which moved lights (compared.cpp) would miss.
glm::dvec3 pointOn(const Mesh& mesh, Draw& draw);

/// Lights in odd places, a background, a lamp, and what the integrator takes: of a strength that
/// unit surfaces around the origin show.
void addLighting(const Kind& kind, Scene& scene, Draw& draw, std::string& traits);

}  // namespace laver::test
