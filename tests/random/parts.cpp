#include "random/parts.h"

#include <array>

#include "scene/transform.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

using glm::dvec3;

void addTriangle(obj::ObjData& data, dvec3 a, dvec3 b, dvec3 c) {
  const auto first = static_cast<std::uint32_t>(data.positions.size());
  data.positions.insert(data.positions.end(), {a, b, c});
  data.triangles.emplace_back(first, first + 1, first + 2);
}

Part box(Draw&) {
  Part part{"box", {}};
  for (int i = 0; i < 8; ++i)
    part.data.positions.emplace_back((i & 1) - 0.5, (i >> 1 & 1) - 0.5, (i >> 2 & 1) - 0.5);
  for (const glm::uvec4 q :
       {glm::uvec4(0, 2, 3, 1), glm::uvec4(4, 5, 7, 6), glm::uvec4(0, 1, 5, 4),
        glm::uvec4(2, 6, 7, 3), glm::uvec4(0, 4, 6, 2), glm::uvec4(1, 3, 7, 5)}) {
    part.data.triangles.emplace_back(q.x, q.y, q.z);
    part.data.triangles.emplace_back(q.z, q.w, q.x);
  }
  return part;
}

Part ballOf(Draw& draw) {
  const Mesh mesh = bumpySphere(static_cast<unsigned>(draw.integer(4, 7)),
                                static_cast<unsigned>(draw.integer(5, 9)), 0.1, dvec3(0.0));
  Part part{"closed mesh", {}};
  part.data.positions = mesh.positions;
  part.data.triangles = mesh.triangles;
  return part;
}

Part grid(Draw& draw) {
  constexpr unsigned kCells = 4;
  Part part{"sheet", {}};
  const double height = draw.chance(0.5) ? 0.0 : 0.2;
  for (unsigned y = 0; y <= kCells; ++y)
    for (unsigned x = 0; x <= kCells; ++x) {
      part.data.positions.emplace_back(2.0 * x / kCells - 1.0, height * draw.unit(),
                                       2.0 * y / kCells - 1.0);
      part.data.uvs.emplace_back(3.0 * x / kCells, 3.0 * y / kCells);
    }
  for (unsigned y = 0; y < kCells; ++y)
    for (unsigned x = 0; x < kCells; ++x) {
      const unsigned i = y * (kCells + 1) + x, up = i + kCells + 1;
      part.data.triangles.emplace_back(i, up, i + 1);
      part.data.triangles.emplace_back(up, up + 1, i + 1);
    }
  return part;
}

/// Triangles around one corner; the narrow ones fill a small angle only.
Part fan(Draw& draw) {
  const int blades = draw.integer(6, 30);
  const double angle = draw.chance(0.5) ? 2.0 * std::numbers::pi : draw.scale(1e-4, 1.0);
  Part part{"fan", {}};
  part.data.positions.emplace_back(0.0);
  for (int i = 0; i <= blades; ++i) {
    const double phi = angle * i / blades;
    part.data.positions.emplace_back(std::cos(phi), draw.chance(0.5) ? 0.0 : 0.1, std::sin(phi));
  }
  for (unsigned i = 1; i <= static_cast<unsigned>(blades); ++i)
    part.data.triangles.emplace_back(0, i + 1, i);
  return part;
}

/// A strip of triangles of one width, side by side.
Part slivers(Draw& draw) {
  const double width = draw.scale(1e-6, 1e-2);
  Part part{"slivers", {}};
  for (int i = 0; i < 8; ++i) {
    const dvec3 step(0.0, 0.0, width * i), next(0.0, 0.0, width * (i + 1));
    addTriangle(part.data, dvec3(-1.0, 0.0, 0.0) + step, dvec3(1.0, 0.0, 0.0) + next,
                dvec3(1.0, 0.0, 0.0) + step);
  }
  addTriangle(part.data, dvec3(-1.0, 0.3, 0.5), dvec3(1.0, 0.3, 0.5), draw.point());
  return part;
}

Part soup(Draw& draw) {
  Part part{"soup", {}};
  for (int i = draw.integer(3, 24); i > 0; --i) {
    const dvec3 at = draw.point();
    const double size = draw.scale(1e-4, 1.0);
    addTriangle(part.data, at, at + size * draw.point(), at + size * draw.point());
  }
  return part;
}

/// No area, none left in float, and two corners that coincide; one ordinary triangle shows.
Part degenerate(Draw& draw) {
  Part part{"degenerate", {}};
  const dvec3 a = draw.point(), b = draw.point();
  addTriangle(part.data, a, b, 0.5 * (a + b));
  addTriangle(part.data, a, a, b);
  addTriangle(part.data, a, a, a);
  addTriangle(part.data, a, b, 0.5 * (a + b) + draw.scale(1e-20, 1e-7) * draw.point());
  addTriangle(part.data, a, a + 1e-9 * draw.point(), a + 1e-9 * draw.point());
  addTriangle(part.data, a, b, draw.point());
  return part;
}

/// Equal triangles, some with corners in another order, and some a little apart.
Part coincident(Draw& draw, bool contested) {
  Part part{"coincident", {}};
  const dvec3 a = draw.point(), b = draw.point(), c = draw.point();
  // Whether one shadows the other is a matter of rounding where a gap is narrower than the offset
  // of shadow rays, some 8 * 2^-24 of coordinates (tests/stability/contact.cpp): no bound of
  // host/lab/explain covers it.
  const dvec3 gap = draw.chance(0.5) ? dvec3(0.0) : draw.scale(1e-4, 1e-2) * draw.direction();
  addTriangle(part.data, a, b, c);
  addTriangle(part.data, b, c, a);
  addTriangle(part.data, c, b, a);
  addTriangle(part.data, a + gap, b + gap, c + gap);
  // In the same plane, overlapping by a half.
  if (contested) addTriangle(part.data, a, b, 0.5 * (a + c));
  return part;
}

}  // namespace

Part randomPart(Draw& draw, bool contested) {
  static constexpr std::array kMakers{box, ballOf, grid, fan, slivers, soup, degenerate};
  const std::size_t maker = draw.below(kMakers.size() + 1);
  return maker == kMakers.size() ? coincident(draw, contested) : kMakers[maker](draw);
}

std::string addNormals(obj::ObjData& data, Draw& draw) {
  const std::array<const char*, 4> names{"rounded normals", "random normals", "opposite normals",
                                         "zero normals"};
  const std::size_t kind = draw.below(names.size());
  for (std::size_t i = 0; i < data.positions.size(); ++i) {
    const dvec3 outwards = normalizedOrZero(data.positions[i] + dvec3(0.0, 0.1, 0.0));
    data.normals.push_back(kind == 0   ? outwards
                           : kind == 1 ? draw.direction()
                           : kind == 2 ? (i % 2 == 0 ? outwards : -outwards)
                                       : (i % 3 == 0 ? dvec3(0.0) : outwards));
  }
  return names[kind];
}

glm::dmat4 randomTransform(Draw& draw, std::string& name) {
  glm::dmat4 result = rotation(draw.direction(), draw.between(0.0, 360.0)).value_or(glm::dmat4(1));
  if (draw.chance(0.2)) {
    name += " stretched";
    result *= glm::dmat4(glm::dmat3(glm::dvec3(draw.scale(1e-2, 1.0), 0, 0),
                                    glm::dvec3(0, draw.scale(1e-2, 1.0), 0), glm::dvec3(0, 0, 1)));
  }
  if (draw.chance(0.2)) {
    name += " sheared";
    glm::dmat4 shear(1.0);
    shear[1][0] = draw.between(-3.0, 3.0);
    result *= shear;
  }
  if (draw.chance(0.2)) {
    name += " mirrored";
    result[0] = -result[0];
  }
  return result;
}

}  // namespace laver::test
