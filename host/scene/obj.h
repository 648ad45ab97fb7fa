#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace laver::obj {

/// Geometry of an OBJ file in the file's own space: one entry per distinct corner (v, vt, vn), in
/// the order of first use. An attribute that no corner has is empty; corners without an attribute
/// that others have get 0.
struct ObjData {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;  ///< as in the file, of any length
  std::vector<glm::dvec2> uvs;
  std::vector<glm::uvec3> triangles;
  /// Indices of the self-intersecting polygons, counting polygons of five or more corners from 0.
  std::vector<std::size_t> crossing;
};

/// Number of statements of each kind in an OBJ text.
struct Counts {
  std::uint64_t positions = 0, uvs = 0, normals = 0;
  std::uint64_t faces = 0;    ///< with three or more corners
  std::uint64_t indices = 0;  ///< three per triangle after triangulation
  bool operator==(const Counts&) const = default;
  std::uint64_t max() const { return std::max({positions, uvs, normals, indices}); }
};

/// An error or a warning about an OBJ text.
struct Issue {
  std::size_t line;  ///< from 1
  std::string message;
};

/// The result of check().
struct Checked {
  std::string text;  ///< that parse() reads correctly, if there are no errors
  Counts counts;
  std::vector<Issue> errors;  ///< in file order, the first ten
  std::vector<Issue> warnings;
  std::vector<std::size_t> polygonLines;  ///< of the polygons with five or more corners
};

/// The result of read().
struct ReadResult {
  ObjData data;
  std::vector<Issue> errors, warnings;
  bool checked = false;  ///< the text was not plain and went through check()
};

/// The result of load().
struct LoadResult {
  ObjData data;
  std::string problem;              ///< error of the whole file: "no such file", ...; empty: none
  std::vector<std::string> errors;  ///< complete lines `file:line: error: ...`
  std::vector<std::string> warnings;
  bool checked = false;  ///< as in ReadResult
};

/// Vertices and triangle corners are numbered by 32-bit integers, here and in tinyobjloader.
inline constexpr std::uint64_t kMaxIndices = 0x7fffffff;

/// Statements other than v, vt, vn and f that define no surface, or nothing that triangles need.
inline constexpr std::array<std::string_view, 20> kIgnored = {
    "o", "g",  "s",  "mg",  "usemtl", "mtllib", "usemap",   "maplib",   "l",          "p",
    "t", "vp", "vw", "lod", "bevel",  "end",    "c_interp", "d_interp", "shadow_obj", "trace_obj"};

/// Counts the statements of a plain text, one that parse() reads correctly without changes. Nothing
/// if the text has an error, may have one, or has a construct that tinyobjloader misreads. Values
/// are not read, so indices may still be out of range.
std::optional<Counts> scanPlain(const std::string& text);

/// Examines every word and finds all errors with their lines, since tinyobjloader silently reads
/// malformed numbers as 0. In the returned text, a byte order mark, comments after data, faces of
/// fewer than three corners and the ends of continued lines are blanked, and numbers and corners
/// that tinyobjloader would misread are rewritten. More than `maxIndices` vertices or triangle
/// corners are an error.
Checked check(std::string text, std::uint64_t maxIndices = kMaxIndices);

/// Parses a text with tinyobjloader. Polygons become triangles: a quad (a b c d) gives (a,b,c) and
/// (d,a,c), larger ones the result of triangulate(). Indices of texture coordinates and normals are
/// ignored if the file has none at all. Nothing if the parser finds other counts than `expected` or
/// an index out of range.
std::optional<ObjData> parse(const std::string& text, const Counts& expected);

/// Parses a plain text in one pass; any other text is checked first. Throws std::logic_error if the
/// parser and check() disagree.
ReadResult read(std::string text, std::uint64_t maxIndices = kMaxIndices);

/// Reads an OBJ file. Throws nothing: even running out of memory is reported as a problem.
LoadResult load(const std::string& file);

/// Transforms points and normals, and drops triangles without area. Name, material and sphere of
/// the mesh are not set. Nothing if a point goes to infinity.
std::optional<Mesh> toWorld(const ObjData& data, const glm::dmat4& toWorld);

}  // namespace laver::obj
