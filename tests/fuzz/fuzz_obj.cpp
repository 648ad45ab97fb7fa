// Arbitrary bytes as an OBJ file cause errors, or a mesh with the vertices of the file. A text that
// is parsed without a check gives the same data as one that is checked first.
#include <algorithm>
#include <bit>
#include <cmath>

#include "fuzz/fuzz.h"
#include "scene/numbers.h"
#include "scene/obj.h"

namespace laver::fuzz {
namespace {

// The vertices of a checked text, which has no comments after data and no continued lines, by a
// parser that is independent of tinyobjloader.
std::vector<glm::dvec3> verticesOf(const std::string& text) {
  std::vector<glm::dvec3> vertices;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    std::vector<double> numbers;
    const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
    begin = end + 1;
    if (!line.starts_with("v ") && !line.starts_with("v\t")) continue;
    for (const std::string_view word : splitList(line.substr(1))) {
      numbers.push_back(parseReal(word).value);
    }
    require(numbers.size() >= 3, "a vertex has three coordinates");
    vertices.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
  return vertices;
}

// tinyobjloader rounds digit by digit.
bool near(double a, double b) {
  return std::abs(a - b) <= 1e-12 * std::max(std::abs(a), std::abs(b)) + 1e-300;
}

void checkData(const obj::ObjData& data, const obj::Checked& checked) {
  const std::size_t count = data.positions.size();
  require(data.triangles.size() * 3 == checked.counts.indices, "triangles are as many as counted");
  require(data.uvs.empty() || data.uvs.size() == count, "a vertex has a texture coordinate");
  require(data.normals.empty() || data.normals.size() == count, "a vertex has a normal");
  for (const glm::uvec3& t : data.triangles) {
    require(t.x < count && t.y < count && t.z < count, "corners are vertices");
  }
  const auto vertices = verticesOf(checked.text);
  for (const glm::dvec3& p : data.positions) {
    const auto same = [&](const glm::dvec3& v) {
      return near(v.x, p.x) && near(v.y, p.y) && near(v.z, p.z);
    };
    require(std::any_of(vertices.begin(), vertices.end(), same), "a vertex is one of the file's");
  }
}

template <class Vector>
bool sameBits(const std::vector<Vector>& a, const std::vector<Vector>& b) {
  const auto same = [](const Vector& p, const Vector& q) {
    for (int i = 0; i < Vector::length(); ++i) {
      if (std::bit_cast<std::uint64_t>(p[i]) != std::bit_cast<std::uint64_t>(q[i])) return false;
    }
    return true;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

void checkPlain(const obj::ReadResult& plain, const obj::Checked& checked) {
  require(checked.errors.empty() && checked.warnings.empty(), "a plain text has no errors");
  const auto data = obj::parse(checked.text, checked.counts);
  require(data.has_value(), "a checked text is parsed");
  require(data->triangles == plain.data.triangles && sameBits(data->uvs, plain.data.uvs) &&
              sameBits(data->positions, plain.data.positions) &&
              sameBits(data->normals, plain.data.normals),
          "a check does not change the data of a plain text");
}

void load(const std::string& text) {
  const obj::ReadResult result = obj::read(text);
  for (const auto* issues : {&result.errors, &result.warnings}) {
    for (const obj::Issue& issue : *issues) {
      require(issue.line >= 1, "lines count from 1");
      require(issue.message.find('\n') == std::string::npos, "a message is one line");
    }
  }
  const obj::Checked checked = obj::check(text);
  if (!result.checked) checkPlain(result, checked);
  if (!result.errors.empty()) return;
  checkData(result.data, checked);
  const std::optional<Mesh> mesh = obj::toWorld(result.data, glm::dmat4(1.0));
  if (!mesh) return;
  require(mesh->triangles.size() + mesh->droppedTriangles == result.data.triangles.size(),
          "a triangle is kept or dropped");
}

}  // namespace
}  // namespace laver::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  laver::fuzz::load({reinterpret_cast<const char*>(data), size});
  return 0;
}
