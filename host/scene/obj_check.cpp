#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <utility>

#include "scene/numbers.h"
#include "scene/obj.h"
#include "scene/obj_lines.h"
#include "scene/text_source.h"

namespace laver::obj {
namespace {

constexpr std::size_t kMaxErrors = 10;
constexpr std::array<const char*, 3> kKinds = {"vertex", "texture coordinate", "normal"};

class Checker {
 public:
  Checker(std::string text, std::uint64_t maxIndices)
      : lines_(std::move(text)), maxIndices_(maxIndices) {}

  Checked run() && {
    while (!full() && lines_.next()) checkLine();
    checkUnknown();
    checkFarIndices();
    checkLimits();
    for (const Repeated* repeated : {&short_, &missing_[1], &missing_[2]}) warn(*repeated);
    std::stable_sort(result_.warnings.begin(), result_.warnings.end(),
                     [](const Issue& a, const Issue& b) { return a.line < b.line; });
    std::stable_sort(errors_.begin(), errors_.end(),
                     [](const Place& a, const Place& b) { return a.offset < b.offset; });
    for (Place& error : errors_) {
      result_.errors.push_back({lines_.lineOf(error.offset), std::move(error.message)});
    }
    result_.text = std::move(lines_).takeText();
    return std::move(result_);
  }

 private:
  struct Place {
    std::size_t offset;
    std::string message;
  };
  // An index beyond the elements read so far; later lines may define it. A negative index beyond
  // the first element is invalid, unless its list stays empty.
  struct FarIndex {
    std::size_t offset;
    std::size_t kind;  // of kKinds
    std::int64_t index;
  };
  // A warning given once, with the number of its occurrences.
  struct Repeated {
    std::size_t line = 0;  // of the first
    std::string message;   // with a placeholder for the number
    std::uint64_t count = 0;
  };

  static void note(Repeated& repeated, std::size_t line, const char* message) {
    if (repeated.count++ == 0) repeated = {line, message, 1};
  }
  void warn(const Repeated& repeated) {
    if (repeated.count == 0) return;
    result_.warnings.push_back(
        {repeated.line, fmt::format(fmt::runtime(repeated.message), repeated.count)});
  }

  std::int64_t countOf(std::size_t kind) const {
    const Counts& c = result_.counts;
    return static_cast<std::int64_t>(std::array{c.positions, c.uvs, c.normals}[kind]);
  }

  bool full() const { return errors_.size() >= kMaxErrors; }
  void error(std::size_t offset, std::string message) {
    if (!full()) errors_.push_back({offset, std::move(message)});
  }

  void checkLine() {
    const std::string_view statement = lines_.words()[0];
    Counts& counts = result_.counts;
    if (statement == "v") {
      checkNumbers(3, 8);  // weight and colour may follow
      ++counts.positions;
    } else if (statement == "vt") {
      checkNumbers(1, 3);
      ++counts.uvs;
    } else if (statement == "vn") {
      checkNumbers(3, 3);
      ++counts.normals;
    } else if (statement == "f") {
      checkFace();
    } else if (std::find(kIgnored.begin(), kIgnored.end(), statement) == kIgnored.end()) {
      if (unknown_++ == 0) firstUnknown_ = {lines_.offset(), xml::inQuotes(statement)};
    }
  }

  // A text with only unknown statements is a file of another kind.
  void checkUnknown() {
    if (unknown_ == 0) return;
    const auto& [offset, statement] = firstUnknown_;
    if (result_.counts.max() == 0 && short_.count == 0) {
      error(offset, fmt::format("{} is no statement of OBJ, and no line of the file is a vertex or "
                                "a face",
                                statement));
      return;
    }
    const std::string more =
        unknown_ == 1 ? ""
                      : fmt::format(", and so are {} more lines of unknown kinds", unknown_ - 1);
    result_.warnings.push_back(
        {lines_.lineOf(offset), fmt::format("unknown statement {} is ignored{}", statement, more)});
  }

  void checkNumbers(std::size_t min, std::size_t max) {
    const auto& words = lines_.words();
    const std::size_t count = words.size() - 1;
    if (count < min || count > max) {
      const std::string wanted =
          min == max ? fmt::format("{}", min) : fmt::format("{} to {}", min, max);
      error(lines_.offset(),
            fmt::format("\"{}\" takes {} numbers, found {}", words[0], wanted, count));
    }
    for (std::size_t i = 1; i < words.size(); ++i) {
      const auto number = parseReal(words[i]);
      if (number) {
        simplify(words[i], number.value);
        continue;
      }
      error(lines_.offsetOf(words[i]),
            fmt::format("{} {}", xml::inQuotes(words[i]), number.problem));
    }
  }

  // tinyobjloader reads 0e400 as NaN, overflows in the exponent of 1e-9999999999, and loses
  // precision with hundreds of digits. The shortest form of a double has at most 24 characters.
  void simplify(std::string_view word, double value) {
    std::array<char, 24> shortest;
    if (value != 0.0 && word.size() <= shortest.size()) return;
    const auto end = std::to_chars(shortest.begin(), shortest.end(), value).ptr;
    const auto size = static_cast<std::size_t>(end - shortest.begin());
    lines_.replace(word, {shortest.data(), size});
  }

  void checkFace() {
    const auto& words = lines_.words();
    const std::size_t count = words.size() - 1;
    for (std::size_t i = 1; i < words.size(); ++i) checkCorner(words[i]);
    if (count < 3) {
      note(short_, lines_.line(), "faces of fewer than 3 corners are skipped: {} in this file");
      for (const std::string_view word : words) lines_.replace(word, "");
      return;
    }
    ++result_.counts.faces;
    result_.counts.indices += 3 * (count - 2);
    if (count > 4) result_.polygonLines.push_back(lines_.line());
  }

  // v/vt/vn, of which vt and vn may be empty or 0, as Cinema 4D writes, or absent together with
  // their slash.
  void checkCorner(std::string_view corner) {
    const std::size_t offset = lines_.offsetOf(corner);
    std::array<std::string_view, 3> parts;
    std::array<bool, 3> given{};
    std::string_view rest = corner;
    for (std::size_t kind = 0; kind < parts.size(); ++kind) {
      const std::size_t slash = std::min(rest.find('/'), rest.size());
      parts[kind] = rest.substr(0, slash);
      const bool last = slash == rest.size() || kind + 1 == parts.size();
      const auto index = indexOf(parts[kind]);
      if ((!index && (kind == 0 || !parts[kind].empty())) || (last && slash != rest.size())) {
        error(offset, fmt::format("{} is not a corner, expected v, v/vt, v//vn or v/vt/vn",
                                  xml::inQuotes(corner)));
        return;
      }
      given[kind] = index.value_or(0) != 0;
      if (given[kind] || kind == 0) checkIndex(offset, kind, *index);
      if (last) break;
      rest.remove_prefix(slash + 1);
    }
    if (corner.ends_with('/') || !(given[1] || parts[1].empty()) || !(given[2] || parts[2].empty()))
      lines_.replace(corner, fmt::format("{}{}{}{}{}", parts[0], given[1] || given[2] ? "/" : "",
                                         given[1] ? parts[1] : "", given[2] ? "/" : "",
                                         given[2] ? parts[2] : ""));
  }

  // An index that does not fit in 64 bits is out of every range.
  static std::optional<std::int64_t> indexOf(std::string_view text) {
    std::int64_t index = 0;
    const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (fault == std::errc::invalid_argument || stop != text.data() + text.size())
      return std::nullopt;
    if (fault == std::errc::result_out_of_range) {
      index = text[0] == '-' ? std::numeric_limits<std::int64_t>::min()
                             : std::numeric_limits<std::int64_t>::max();
    }
    return index;
  }

  void checkIndex(std::size_t offset, std::size_t kind, std::int64_t index) {
    const std::int64_t soFar = countOf(kind);
    if (index == 0) {
      error(offset, fmt::format("{} index 0, OBJ counts from 1", kKinds[kind]));
    } else if (index > soFar || (index < 0 && soFar == 0 && kind != 0)) {
      far_.push_back({offset, kind, index});
    } else if (index < -soFar) {
      tooFarBack(offset, kind, index, soFar);
    }
  }

  void tooFarBack(std::size_t offset, std::size_t kind, std::int64_t index, std::int64_t soFar) {
    error(offset, fmt::format("{} index {} goes back too far, there are {} so far", kKinds[kind],
                              index, soFar));
  }

  // Without texture coordinates or normals in the file, their indices are ignored, as in Nori and
  // Blender.
  void checkFarIndices() {
    constexpr std::array<const char*, 3> kMissing = {
        "", "{} corners name texture coordinates, of which the file has none: they get none",
        "{} corners name normals, of which the file has none: the geometric normal is used"};
    for (const FarIndex& far : far_) {
      const std::int64_t count = countOf(far.kind);
      if (count == 0 && far.kind != 0) {
        Repeated& missing = missing_[far.kind];
        note(missing, missing.count == 0 ? lines_.lineOf(far.offset) : 0, kMissing[far.kind]);
      } else if (far.index < 0) {
        tooFarBack(far.offset, far.kind, far.index, 0);
      } else if (far.index > count) {
        error(far.offset, fmt::format("{} index {} is out of range, the file has {}",
                                      kKinds[far.kind], far.index, count));
      }
    }
  }

  void checkLimits() {
    const Counts& counts = result_.counts;
    if (counts.max() <= maxIndices_) return;
    error(0, fmt::format("too large: {} vertices, {} triangle corners, at most {} of each are "
                         "possible",
                         counts.positions, counts.indices, maxIndices_));
  }

  Lines lines_;
  std::uint64_t maxIndices_;
  Checked result_;
  std::vector<Place> errors_;
  std::vector<FarIndex> far_;
  Repeated short_;                                    // faces
  std::array<Repeated, 3> missing_;                   // lists, by kind
  std::uint64_t unknown_ = 0;                         // statements
  std::pair<std::size_t, std::string> firstUnknown_;  // its offset and name
};

}  // namespace

Checked check(std::string text, std::uint64_t maxIndices) {
  if (const std::size_t nul = text.find('\0'); nul != std::string::npos) {
    const std::size_t line = Lines(std::move(text)).lineOf(nul);
    return {{}, {}, {{line, "a NUL byte, expected a text file"}}, {}, {}};
  }
  return Checker(std::move(text), maxIndices).run();
}

}  // namespace laver::obj
