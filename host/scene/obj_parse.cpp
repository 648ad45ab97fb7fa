// The only file that sees tinyobjloader: its type of number depends on this macro.
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <istream>
#include <streambuf>

#include "scene/obj.h"

namespace laver::obj {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isBlank(char c) { return c == ' ' || c == '\t'; }
bool isLineEnd(char c) { return c == '\n' || c == '\r' || c == '\0'; }
bool isWordEnd(char c) { return isBlank(c) || isLineEnd(c); }

// Accepts texts by their grammar alone. Every loop stops at the string's closing NUL.
class PlainScan {
 public:
  explicit PlainScan(const std::string& text) : at_(text.data()), end_(at_ + text.size()) {}

  std::optional<Counts> run() {
    while (at_ < end_) {
      skipBlanks();
      if (!scanLine()) return std::nullopt;
      if (at_ < end_) ++at_;
    }
    return counts_;
  }

 private:
  void skipBlanks() {
    while (isBlank(*at_)) ++at_;
  }

  std::size_t skipDigits() {
    const char* begin = at_;
    while (isDigit(*at_)) ++at_;
    return static_cast<std::size_t>(at_ - begin);
  }

  // Goes to the end of the line.
  bool scanLine() {
    if (at_[0] == 'v' && isBlank(at_[1])) {
      ++at_;
      ++counts_.positions;
      return scanNumbers(3, 8);  // weight and colour may follow
    }
    if (at_[0] == 'f' && isBlank(at_[1])) {
      ++at_;
      return scanFace();
    }
    if (at_[0] == 'v' && at_[1] == 'n' && isBlank(at_[2])) {
      at_ += 2;
      ++counts_.normals;
      return scanNumbers(3, 3);
    }
    if (at_[0] == 'v' && at_[1] == 't' && isBlank(at_[2])) {
      at_ += 2;
      ++counts_.uvs;
      return scanNumbers(1, 3);
    }
    return scanIgnored();
  }

  // Empty lines, comments, and statements whose arguments do not matter. A backslash at the end may
  // continue a line.
  bool scanIgnored() {
    const char* begin = at_;
    while (!isLineEnd(*at_)) ++at_;
    if (at_ == begin || *begin == '#') return true;
    const std::string_view line(begin, at_);
    const std::string_view statement = line.substr(0, line.find_first_of(" \t#"));
    return line.back() != '\\' &&
           std::find(kIgnored.begin(), kIgnored.end(), statement) != kIgnored.end();
  }

  bool scanNumbers(int min, int max) {
    int count = 0;
    for (skipBlanks(); !isLineEnd(*at_); skipBlanks()) {
      if (!scanNumber()) return false;
      ++count;
    }
    return count >= min && count <= max;
  }

  // Numbers that neither overflow nor lose all digits: at most 24 characters (the longest shortest
  // form of a double), and exponents of two digits, or three of which the first is 0.
  bool scanNumber() {
    const char* begin = at_;
    if (*at_ == '+' || *at_ == '-') ++at_;
    std::size_t digits = skipDigits();
    if (*at_ == '.') {
      ++at_;
      digits += skipDigits();
    }
    if (digits == 0) return false;
    if (*at_ == 'e' || *at_ == 'E') {
      ++at_;
      if (*at_ == '+' || *at_ == '-') ++at_;
      const char first = *at_;
      const std::size_t exponent = skipDigits();
      if (exponent == 0 || exponent > 3 || (exponent == 3 && first != '0')) return false;
    }
    return isWordEnd(*at_) && at_ - begin <= 24;
  }

  bool scanFace() {
    std::uint64_t count = 0;
    for (skipBlanks(); !isLineEnd(*at_); skipBlanks()) {
      if (!scanCorner()) return false;
      ++count;
    }
    if (count < 3) return false;
    ++counts_.faces;
    counts_.indices += 3 * (count - 2);
    return true;
  }

  // v, v/vt, v//vn or v/vt/vn
  bool scanCorner() {
    if (!scanIndex()) return false;
    if (*at_ != '/') return isWordEnd(*at_);
    ++at_;
    if (*at_ != '/') {
      if (!scanIndex()) return false;
      if (*at_ != '/') return isWordEnd(*at_);
    }
    ++at_;
    return scanIndex() && isWordEnd(*at_);
  }

  // Not 0, which tinyobjloader does not tell from a missing index, and within 32 bits.
  bool scanIndex() {
    if (*at_ == '-') ++at_;
    if (*at_ == '0') return false;
    const std::size_t digits = skipDigits();
    return digits >= 1 && digits <= 9;
  }

  const char* at_;
  const char* end_;
  Counts counts_;
};

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

// Collects what tinyobjloader reports. Faces may come before their vertices, so the ranges of
// indices follow from the expected counts.
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
    return std::move(data_);
  }

 private:
  // From the file's index, which counts from 1, or back from what was read so far if negative; 0:
  // not given.
  int absolute(int index, std::size_t soFar, std::uint64_t count) {
    if (index == 0) return -1;
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
    for (std::size_t i = 2; i < face_.size(); ++i) {
      data_.triangles.emplace_back(face_[0], face_[i - 1], face_[i]);
    }
  }

  Counts expected_;
  std::vector<glm::dvec3> positions_, normals_;
  std::vector<glm::dvec2> uvs_;
  std::vector<Corner> corners_;
  std::vector<int> firstCorner_;  // by v
  std::vector<unsigned> face_;
  std::uint64_t faces_ = 0;
  bool indexOutOfRange_ = false;
  ObjData data_;
};

}  // namespace

std::optional<Counts> scanPlain(const std::string& text) {
  if (text.find('\0') != std::string::npos) return std::nullopt;
  return PlainScan(text).run();
}

std::optional<ObjData> parse(const std::string& text, const Counts& expected) {
  ViewBuffer buffer(text);
  std::istream stream(&buffer);
  Builder builder(expected);
  if (!tinyobj::LoadObjWithCallback(stream, Builder::callbacks(), &builder)) return std::nullopt;
  return std::move(builder).finish();
}

}  // namespace laver::obj
