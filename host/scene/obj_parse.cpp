// The only file that sees tinyobjloader: its type of number depends on this macro.
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <istream>
#include <stdexcept>
#include <streambuf>

#include "scene/obj_data.h"

namespace laver::obj {
namespace {

// Reads a string without copying it.
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

class Builder {
 public:
  explicit Builder(const Counts& expected) : firstCorner_(expected.positions, -1) {
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

  ObjData finish(const Counts& expected) && {
    const Counts seen{positions_.size(), uvs_.size(), normals_.size(), faces_,
                      data_.triangles.size() * 3};
    if (seen != expected) throw std::logic_error("the OBJ parser and the checker disagree");
    bool anyUv = false, anyNormal = false;
    for (const Corner& corner : corners_) {
      anyUv = anyUv || corner.vt >= 0;
      anyNormal = anyNormal || corner.vn >= 0;
    }
    const auto pick = [](const auto& from, int index, auto none) {
      return index < 0 ? none : from.at(static_cast<std::size_t>(index));
    };
    data_.positions.reserve(corners_.size());
    if (anyUv) data_.uvs.reserve(corners_.size());
    if (anyNormal) data_.normals.reserve(corners_.size());
    for (const Corner& corner : corners_) {
      data_.positions.push_back(positions_.at(static_cast<std::size_t>(corner.v)));
      if (anyUv) data_.uvs.push_back(pick(uvs_, corner.vt, glm::dvec2(0.0)));
      if (anyNormal) data_.normals.push_back(pick(normals_, corner.vn, glm::dvec3(0.0)));
    }
    return std::move(data_);
  }

 private:
  // From 1, or negative and relative to what was read so far; 0: not given.
  static int absolute(int index, std::size_t count) {
    return index < 0 ? static_cast<int>(count) + index : index - 1;
  }

  unsigned cornerOf(const tinyobj::index_t& raw) {
    const int v = absolute(raw.vertex_index, positions_.size());
    const int vt = absolute(raw.texcoord_index, uvs_.size());
    const int vn = absolute(raw.normal_index, normals_.size());
    int* link = &firstCorner_.at(static_cast<std::size_t>(v));
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
    for (std::size_t i = 2; i < face_.size(); ++i) {
      data_.triangles.emplace_back(face_[0], face_[i - 1], face_[i]);
    }
  }

  std::vector<glm::dvec3> positions_, normals_;
  std::vector<glm::dvec2> uvs_;
  std::vector<Corner> corners_;
  std::vector<int> firstCorner_;  // by v
  std::vector<unsigned> face_;
  std::uint64_t faces_ = 0;
  ObjData data_;
};

}  // namespace

ObjData parse(const std::string& text, const Counts& expected) {
  ViewBuffer buffer(text);
  std::istream stream(&buffer);
  Builder builder(expected);
  std::string warning, error;
  if (!tinyobj::LoadObjWithCallback(stream, Builder::callbacks(), &builder, nullptr, &warning,
                                    &error)) {
    throw std::logic_error("the OBJ parser refuses what the checker accepts: " + error);
  }
  return std::move(builder).finish(expected);
}

}  // namespace laver::obj
