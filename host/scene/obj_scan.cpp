#include <algorithm>

#include "scene/obj.h"

namespace laver::obj {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isBlank(char c) { return c == ' ' || c == '\t'; }
bool isLineEnd(char c) { return c == '\n' || c == '\r' || c == '\0'; }
bool isWordEnd(char c) { return isBlank(c) || isLineEnd(c); }

// Accepts texts by their grammar alone. Every loop stops at the string's terminating NUL.
class PlainScan {
 public:
  explicit PlainScan(const std::string& text) : at_(text.data()), end_(at_ + text.size()) {}

  std::optional<Counts> run() {
    while (at_ < end_) {
      skipBlanks();
      if (!scanLine()) return std::nullopt;
      if (at_ < end_) ++at_;
    }
    // Indices of elements that the file does not have need a warning.
    if ((namesUvs_ && counts_.uvs == 0) || (namesNormals_ && counts_.normals == 0))
      return std::nullopt;
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

  // Moves to the end of the line; false if the line is not plain.
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

  // Accepts empty lines, comments, and statements whose arguments do not matter, but no backslash
  // at the end, which may continue a line.
  bool scanIgnored() {
    const char* begin = at_;
    while (!isLineEnd(*at_)) ++at_;
    if (at_ == begin || *begin == '#') return true;
    const std::string_view line(begin, at_);
    const std::string_view statement = line.substr(0, line.find_first_of(" \t"));
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

  // Accepts numbers that neither overflow nor lose all digits: at most 24 characters (the length of
  // the longest shortest form of a double), and exponents of two digits, or three of which the
  // first is 0.
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
      namesUvs_ = true;
      if (*at_ != '/') return isWordEnd(*at_);
    }
    ++at_;
    namesNormals_ = true;
    return scanIndex() && isWordEnd(*at_);
  }

  // Accepts indices except 0, which tinyobjloader cannot distinguish from a missing index, within
  // 32 bits.
  bool scanIndex() {
    if (*at_ == '-') ++at_;
    if (*at_ == '0') return false;
    const std::size_t digits = skipDigits();
    return digits >= 1 && digits <= 9;
  }

  const char* at_;
  const char* end_;
  Counts counts_;
  bool namesUvs_ = false, namesNormals_ = false;
};

}  // namespace

std::optional<Counts> scanPlain(const std::string& text) {
  if (text.find('\0') != std::string::npos) return std::nullopt;
  return PlainScan(text).run();
}

}  // namespace laver::obj
