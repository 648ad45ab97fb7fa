#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace laver::obj {

/// What an OBJ file holds, in the file's own space, one entry a distinct corner (v, vt, vn) in the
/// order of first use. An attribute that no corner has is empty; one that a corner lacks is 0.
struct ObjData {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  ///< as the file gives them, of any length
  std::vector<glm::dvec2> uvs;
  std::vector<glm::uvec3> triangles;
};

/// How many of each an OBJ file has.
struct Counts {
  std::uint64_t positions = 0, uvs = 0, normals = 0, faces = 0;
  std::uint64_t indices = 0;  ///< three a triangle after triangulation
  bool operator==(const Counts&) const = default;
};

/// A fault of an OBJ file.
struct Issue {
  std::size_t line;  ///< from 1
  std::string message;
};

/// What check() finds.
struct CheckResult {
  Counts counts;
  std::vector<Issue> errors;  ///< in file order, the first ten
  std::vector<Issue> warnings;
};

/// Looks at every line of an OBJ text, as tinyobjloader reads faulty numbers as 0 and says nothing.
/// Blanks in place what that parser does not know: a byte order mark, comments behind data, the
/// ends of continued lines. Numbers that it would not read right are rewritten. More than
/// `maxIndices` vertices or triangle corners are an error.
CheckResult check(std::string& text, std::uint64_t maxIndices = 0x7fffffff);

/// Parses a text that check() found no error in. Polygons become triangles: a quad (a b c d) gives
/// (a,b,c),(d,a,c), larger ones a fan about the first corner. Throws std::logic_error if the parser
/// sees other counts than check() did.
ObjData parse(const std::string& text, const Counts& expected);

/// A file's data or why there are none.
struct LoadResult {
  ObjData data;
  std::string problem;              ///< of the whole file: "no such file", ...; empty: none
  std::vector<std::string> errors;  ///< ready lines `file:line: error: ...`
  std::vector<std::string> warnings;
};

/// Reads, checks and parses an OBJ file. Throws nothing: running out of memory is a problem.
LoadResult load(const std::string& file);

/// Fills positions, normals, uvs, triangles and droppedTriangles of `mesh`: points and normals go
/// through toWorld, triangles without area are left out. False if a point goes to infinity.
bool toWorld(const ObjData& data, const glm::dmat4& toWorld, Mesh& mesh);

}  // namespace laver::obj
