// The only file that includes tinyobjloader, whose number type depends on this macro.
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <streambuf>

#include "scene/obj.h"
#include "scene/polygon.h"

namespace laver::obj {
namespace {

// A stream buffer over a string that is not copied.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(const std::string& text) {
    char* begin = const_cast<char*>(text.data());  // never written: there is no put area
    setg(begin, begin, begin + text.size());
  }
};

// A distinct corner; the indices count from 0, -1: none.
struct Corner {
  int v, vt, vn;
  int next;  // the next corner with the same v, -1: none
};

// Collects the data that tinyobjloader reports. Faces may precede their vertices, so the valid
// ranges of indices come from the expected counts.
class Builder {
 public:
  explicit Builder(const Counts& expected)
      : expected_(expected), firstCorner_(expected.positions, -1) {
    positions_.reserve(expected.positions);
    uvs_.reserve(expected.uvs);
    normals_.reserve(expected.normals);
    data_.triangles.reserve(expected.indices / 3);
  }

  static tinyobj::callback_t callbacks() {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* self, double x, double y, double z, double) {
      static_cast<Builder*>(self)->positions_.emplace_back(x, y, z);
    };
    calls.normal_cb = [](void* self, double x, double y, double z) {
      static_cast<Builder*>(self)->normals_.emplace_back(x, y, z);
    };
    calls.texcoord_cb = [](void* self, double u, double v, double) {
      static_cast<Builder*>(self)->uvs_.emplace_back(u, v);
    };
    calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      static_cast<Builder*>(self)->addFace(corners, count);
    };
    return calls;
  }

  std::optional<ObjData> finish() && {
    const Counts found{positions_.size(), uvs_.size(), normals_.size(), faces_,
                       data_.triangles.size() * 3};
    if (found != expected_ || indexOutOfRange_) return std::nullopt;
    const bool anyUv = std::ranges::any_of(corners_, [](const Corner& c) { return c.vt >= 0; });
    const bool anyNormal = std::ranges::any_of(corners_, [](const Corner& c) { return c.vn >= 0; });
    const auto pick = [](const auto& from, int index, auto none) {
      return index < 0 ? none : from[static_cast<std::size_t>(index)];
    };
    data_.positions.reserve(corners_.size());
    if (anyUv) data_.uvs.reserve(corners_.size());
    if (anyNormal) data_.normals.reserve(corners_.size());
    for (const Corner& corner : corners_) {
      data_.positions.push_back(positions_[static_cast<std::size_t>(corner.v)]);
      if (anyUv) data_.uvs.push_back(pick(uvs_, corner.vt, glm::dvec2(0.0)));
      if (anyNormal) data_.normals.push_back(pick(normals_, corner.vn, glm::dvec3(0.0)));
    }
    cutPolygons();
    return std::move(data_);
  }

 private:
  // Converts the file's index, which counts from 1, or if negative, back from the last element
  // read; 0 means absent, and so does any index if the file has no such element.
  int absolute(int index, std::size_t soFar, std::uint64_t count) {
    if (index == 0 || count == 0) return -1;
    const std::int64_t result =
        index < 0 ? static_cast<std::int64_t>(soFar) + index : std::int64_t{index} - 1;
    if (result < 0 || result >= static_cast<std::int64_t>(count)) indexOutOfRange_ = true;
    return static_cast<int>(result);
  }

  unsigned cornerOf(const tinyobj::index_t& raw) {
    const int v = absolute(raw.vertex_index, positions_.size(), expected_.positions);
    const int vt = absolute(raw.texcoord_index, uvs_.size(), expected_.uvs);
    const int vn = absolute(raw.normal_index, normals_.size(), expected_.normals);
    if (v < 0) indexOutOfRange_ = true;
    if (indexOutOfRange_) return 0;
    int* link = &firstCorner_[static_cast<std::size_t>(v)];
    while (*link >= 0) {
      Corner& corner = corners_[static_cast<std::size_t>(*link)];
      if (corner.vt == vt && corner.vn == vn) return static_cast<unsigned>(*link);
      link = &corner.next;
    }
    *link = static_cast<int>(corners_.size());
    corners_.push_back({v, vt, vn, -1});
    return static_cast<unsigned>(corners_.size() - 1);
  }

  void addFace(const tinyobj::index_t* corners, int count) {
    ++faces_;
    face_.clear();
    for (int i = 0; i < count; ++i) face_.push_back(cornerOf(corners[i]));
    if (count == 4) {
      data_.triangles.emplace_back(face_[0], face_[1], face_[2]);
      data_.triangles.emplace_back(face_[3], face_[0], face_[2]);
      return;
    }
    if (count > 4) polygons_.push_back({data_.triangles.size(), face_.size()});
    for (std::size_t i = 2; i < face_.size(); ++i) {
      data_.triangles.emplace_back(face_[0], face_[i - 1], face_[i]);
    }
  }

  // Polygons are stored as fans until all vertices are known, since vertices may follow them.
  void cutPolygons() {
    std::vector<unsigned> ring;
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      const auto [first, count] = polygons_[i];
      ring = {data_.triangles[first].x, data_.triangles[first].y};
      for (std::size_t t = first; t < first + count - 2; ++t) ring.push_back(data_.triangles[t].z);
      corners.clear();
      for (const unsigned corner : ring) corners.push_back(data_.positions[corner]);
      const Triangulation cut = triangulate(corners);
      std::transform(
          cut.triangles.begin(), cut.triangles.end(),
          data_.triangles.begin() + static_cast<std::ptrdiff_t>(first),
          [&](const glm::uvec3& t) { return glm::uvec3(ring[t.x], ring[t.y], ring[t.z]); });
      if (cut.crossesItself) data_.crossing.push_back(i);
    }
  }

  Counts expected_;
  std::vector<glm::dvec3> positions_, normals_;
  std::vector<glm::dvec2> uvs_;
  std::vector<Corner> corners_;
  std::vector<int> firstCorner_;  // by v
  std::vector<unsigned> face_;
  struct Polygon {
    std::size_t firstTriangle, corners;
  };
  std::vector<Polygon> polygons_;  // with five or more corners
  std::uint64_t faces_ = 0;
  bool indexOutOfRange_ = false;
  ObjData data_;
};

}  // namespace

std::optional<ObjData> parse(const std::string& text, const Counts& expected) {
  ViewBuffer buffer(text);
  std::istream stream(&buffer);
  Builder builder(expected);
  if (!tinyobj::LoadObjWithCallback(stream, Builder::callbacks(), &builder)) return std::nullopt;
  return std::move(builder).finish();
}

}  // namespace laver::obj
