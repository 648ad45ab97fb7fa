// Any bytes as an OBJ file: errors, or a mesh whose vertices are the file's.
#include <algorithm>
#include <cmath>

#include "fuzz/fuzz.h"
#include "scene/numbers.h"
#include "scene/obj_data.h"
#include "scene/obj_lines.h"

namespace laver::fuzz {
namespace {

// The file's vertices, by a parser that shares nothing with tinyobjloader.
std::vector<glm::dvec3> verticesOf(std::string text) {
  std::vector<glm::dvec3> vertices;
  obj::Lines lines(text);
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] != "v") continue;
    vertices.emplace_back(parseReal(words[1]).value, parseReal(words[2]).value,
                          parseReal(words[3]).value);
  }
  return vertices;
}

// tinyobjloader rounds digit by digit.
bool near(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b)) + 1e-300;
}

void checkData(const obj::ObjData& data, const obj::Counts& counts,
               const std::vector<glm::dvec3>& vertices) {
  const std::size_t count = data.positions.size();
  require(data.triangles.size() * 3 == counts.indices, "triangles are as many as counted");
  require(data.uvs.empty() || data.uvs.size() == count, "a vertex has a texture coordinate");
  require(data.normals.empty() || data.normals.size() == count, "a vertex has a normal");
  for (const glm::uvec3& t : data.triangles) {
    require(t.x < count && t.y < count && t.z < count, "corners are vertices");
  }
  for (const glm::dvec3& p : data.positions) {
    const auto same = [&](const glm::dvec3& v) {
      return near(v.x, p.x) && near(v.y, p.y) && near(v.z, p.z);
    };
    require(std::any_of(vertices.begin(), vertices.end(), same), "a vertex is one of the file's");
  }
}

void load(std::string text) {
  const std::string original = text;
  const obj::CheckResult checked = obj::check(text);
  for (const auto* issues : {&checked.errors, &checked.warnings}) {
    for (const obj::Issue& issue : *issues) {
      require(issue.line >= 1, "lines count from 1");
      require(issue.message.find('\n') == std::string::npos, "a message is one line");
    }
  }
  if (!checked.errors.empty()) return;
  const obj::ObjData data = obj::parse(text, checked.counts);
  checkData(data, checked.counts, verticesOf(original));
  Mesh mesh;
  if (!obj::toWorld(data, glm::dmat4(1.0), mesh)) return;
  require(mesh.triangles.size() + mesh.droppedTriangles == data.triangles.size(),
          "a triangle is kept or dropped");
}

}  // namespace
}  // namespace laver::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  laver::fuzz::load({reinterpret_cast<const char*>(data), size});
  return 0;
}
