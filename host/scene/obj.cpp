#include "scene/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

#include "core/lfs_pointer.h"
#include "scene/text_source.h"
#include "scene/transform.h"

namespace laver::obj {
namespace {

LoadResult loadOrThrow(const std::string& file) {
  LoadResult result;
  xml::FileText content = xml::readFile(file);
  if (content.problem.empty() && content.text.find_first_not_of(" \t\r\n") == std::string::npos)
    content.problem = "is empty, expected an OBJ file";
  if (isLfsPointer(content.text)) content.problem = kLfsPointer;
  if (!content.problem.empty()) {
    result.problem = std::move(content.problem);
    return result;
  }
  ReadResult found = read(std::move(content.text));
  for (const Issue& issue : found.errors) {
    result.errors.push_back(fmt::format("{}:{}: error: {}", file, issue.line, issue.message));
  }
  for (const Issue& issue : found.warnings) {
    result.warnings.push_back(fmt::format("{}:{}: warning: {}", file, issue.line, issue.message));
  }
  result.data = std::move(found.data);
  result.checked = found.checked;
  return result;
}

bool isFinite(const glm::dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// Whether the area is exactly zero, not by underflow: the edges are first scaled by a power of two.
bool hasNoArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const auto scaled = [](glm::dvec3 e) {
    int exponent = 0;
    std::frexp(std::max({std::abs(e.x), std::abs(e.y), std::abs(e.z)}), &exponent);
    return glm::dvec3(std::ldexp(e.x, -exponent), std::ldexp(e.y, -exponent),
                      std::ldexp(e.z, -exponent));
  };
  glm::dvec3 cross = glm::cross(b - a, c - a);
  // Only a zero result can be underflow.
  if (cross == glm::dvec3(0.0)) cross = glm::cross(scaled(b - a), scaled(c - a));
  return cross == glm::dvec3(0.0);
}

void warnOfCrossing(ReadResult& result, const std::vector<std::size_t>& polygonLines) {
  const std::vector<std::size_t>& crossing = result.data.crossing;
  if (crossing.empty()) return;
  const std::string others =
      crossing.size() == 1 ? "" : fmt::format(", as do {} more", crossing.size() - 1);
  result.warnings.push_back(
      {polygonLines[crossing.front()],
       fmt::format("the outline of this face crosses itself{}: it has no inside to fill, and parts "
                   "may be covered twice or not at all",
                   others)});
}

}  // namespace

ReadResult read(std::string text, std::uint64_t maxIndices) {
  ReadResult result;
  if (const auto counts = scanPlain(text); counts && counts->max() <= maxIndices) {
    if (auto data = parse(text, *counts)) {
      result.data = std::move(*data);
      if (!result.data.crossing.empty())
        warnOfCrossing(result, check(std::move(text), maxIndices).polygonLines);
      return result;
    }
  }
  Checked checked = check(std::move(text), maxIndices);
  result.checked = true;
  result.errors = std::move(checked.errors);
  result.warnings = std::move(checked.warnings);
  if (!result.errors.empty()) return result;
  auto data = parse(checked.text, checked.counts);
  if (!data) throw std::logic_error("the OBJ parser and the checker disagree");
  result.data = std::move(*data);
  warnOfCrossing(result, checked.polygonLines);
  return result;
}

LoadResult load(const std::string& file) {
  LoadResult result;
  try {
    return loadOrThrow(file);
  } catch (const std::bad_alloc&) {
    result.problem = "is too large for the memory";
  } catch (const std::exception& fault) {
    result.problem = fault.what();
  }
  return result;
}

std::optional<Mesh> toWorld(const ObjData& data, const glm::dmat4& toWorld) {
  Mesh mesh;
  const bool affine = isAffine(toWorld);
  mesh.positions.reserve(data.positions.size());
  for (const glm::dvec3& p : data.positions) {
    const glm::dvec4 q = toWorld * glm::dvec4(p, 1.0);
    const glm::dvec3 world = affine ? glm::dvec3(q) : glm::dvec3(q) / q.w;
    if (!isFinite(world)) return std::nullopt;
    mesh.positions.push_back(world);
  }
  const glm::dmat3 normalToWorld = normalMatrix(toWorld);
  mesh.normals.reserve(data.normals.size());
  for (const glm::dvec3& n : data.normals) {
    mesh.normals.push_back(normalizedOrZero(normalToWorld * normalizedOrZero(n)));
  }
  mesh.uvs = data.uvs;
  mesh.triangles.reserve(data.triangles.size());
  for (const glm::uvec3& t : data.triangles) {
    if (hasNoArea(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z])) continue;
    mesh.triangles.push_back(t);
  }
  mesh.droppedTriangles = data.triangles.size() - mesh.triangles.size();
  return mesh;
}

}  // namespace laver::obj
