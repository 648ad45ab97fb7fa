#pragma once
#include <string>

#include "random/draw.h"
#include "scene/obj.h"

namespace laver::test {

/// Geometry of about unit size around the origin, as in an OBJ file.
struct Part {
  std::string name;
  obj::ObjData data;
};

/// `contested`: surfaces may lie in one plane without being equal. Rounding decides which of them
/// is nearer.
Part randomPart(Draw& draw, bool contested);

/// Vertex normals of some kind: of a sphere, random, opposite within a triangle, or of no length.
/// Returns its name.
std::string addNormals(obj::ObjData& data, Draw& draw);

/// An affine map of about unit scale: rotated, perhaps stretched, sheared or mirrored.
glm::dmat4 randomTransform(Draw& draw, std::string& name);

}  // namespace laver::test
