#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

#include "scene/numbers.h"
#include "scene/obj_data.h"
#include "scene/obj_lines.h"
#include "scene/text_source.h"

namespace laver::obj {
namespace {

constexpr std::size_t kMostErrors = 10;

// Statements that hold no surface, or none that a triangle renderer misses.
constexpr std::array<std::string_view, 20> kHarmless = {
    "o", "g",  "s",  "mg",  "usemtl", "mtllib", "usemap",   "maplib",   "l",          "p",
    "t", "vp", "vw", "lod", "bevel",  "end",    "c_interp", "d_interp", "shadow_obj", "trace_obj"};

constexpr std::array<const char*, 3> kKinds = {"vertex", "texture coordinate", "normal"};

class Checker {
 public:
  Checker(std::string& text, std::uint64_t maxIndices) : lines_(text), maxIndices_(maxIndices) {}

  CheckResult run() {
    while (!full() && lines_.next()) checkLine();
    checkForward();
    checkLimits();
    if (unknown_ > 1) {
      result_.warnings.back().message +=
          fmt::format(", and so are {} more lines of unknown kinds", unknown_ - 1);
    }
    std::stable_sort(faults_.begin(), faults_.end(),
                     [](const Fault& a, const Fault& b) { return a.offset < b.offset; });
    for (Fault& fault : faults_) {
      result_.errors.push_back({lines_.lineOf(fault.offset), std::move(fault.message)});
    }
    return std::move(result_);
  }

 private:
  struct Fault {
    std::size_t offset;
    std::string message;
  };
  struct Forward {
    std::size_t offset;
    std::size_t kind;  // of kKinds
    std::int64_t index;
  };

  std::int64_t countOf(std::size_t kind) const {
    const Counts& c = result_.counts;
    return static_cast<std::int64_t>(std::array{c.positions, c.uvs, c.normals}[kind]);
  }

  bool full() const { return faults_.size() >= kMostErrors; }
  void error(std::size_t offset, std::string message) {
    if (!full()) faults_.push_back({offset, std::move(message)});
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
    } else if (std::find(kHarmless.begin(), kHarmless.end(), statement) == kHarmless.end()) {
      if (unknown_++ > 0) return;
      result_.warnings.push_back(
          {lines_.lineOf(lines_.offset()),
           fmt::format("unknown statement {} is ignored", xml::inQuotes(statement))});
    }
  }

  void checkNumbers(std::size_t least, std::size_t most) {
    const auto& words = lines_.words();
    const std::size_t count = words.size() - 1;
    if (count < least || count > most) {
      const std::string wanted =
          least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
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

  // tinyobjloader makes NaN of 0e400, overflows in the exponent of 1e-9999999999, and loses what
  // hundreds of digits add up to. The shortest form of any double has 24 characters or fewer.
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
    ++result_.counts.faces;
    if (count < 3) {
      error(lines_.offset(), fmt::format("a face takes 3 corners or more, found {}", count));
    } else {
      result_.counts.indices += 3 * (count - 2);
    }
    for (std::size_t i = 1; i < words.size(); ++i) checkCorner(words[i]);
  }

  void checkCorner(std::string_view corner) {
    const std::size_t offset = lines_.offsetOf(corner);
    std::string_view rest = corner;
    bool good = takeIndex(offset, rest, 0);
    if (good && rest.starts_with("//")) {
      rest.remove_prefix(2);
      good = takeIndex(offset, rest, 2);
    } else if (good && rest.starts_with('/')) {
      rest.remove_prefix(1);
      good = takeIndex(offset, rest, 1);
      if (good && rest.starts_with('/')) {
        rest.remove_prefix(1);
        good = takeIndex(offset, rest, 2);
      }
    }
    if (good && rest.empty()) return;
    error(offset, fmt::format("{} is not a corner, expected v, v/vt, v//vn or v/vt/vn",
                              xml::inQuotes(corner)));
  }

  bool takeIndex(std::size_t offset, std::string_view& rest, std::size_t kind) {
    std::int64_t index = 0;
    const auto [stop, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), index);
    if (fault == std::errc::invalid_argument) return false;
    if (fault == std::errc::result_out_of_range) {
      index = rest[0] == '-' ? std::numeric_limits<std::int64_t>::min()
                             : std::numeric_limits<std::int64_t>::max();
    }
    rest.remove_prefix(static_cast<std::size_t>(stop - rest.data()));
    checkIndex(offset, kind, index);
    return true;
  }

  void checkIndex(std::size_t offset, std::size_t kind, std::int64_t index) {
    const std::int64_t soFar = countOf(kind);
    if (index == 0) {
      error(offset, fmt::format("{} index 0, OBJ counts from 1", kKinds[kind]));
    } else if (index < -soFar) {
      error(offset, fmt::format("{} index {} goes back too far, there are {} so far", kKinds[kind],
                                index, soFar));
    } else if (index > soFar) {
      forward_.push_back({offset, kind, index});
    }
  }

  // Indices that were too large where they stood may be met by later lines.
  void checkForward() {
    for (const Forward& f : forward_) {
      if (f.index <= countOf(f.kind)) continue;
      error(f.offset, fmt::format("{} index {} is out of range, the file has {}", kKinds[f.kind],
                                  f.index, countOf(f.kind)));
    }
  }

  // The parser's indices and ours are 32-bit integers.
  void checkLimits() {
    const Counts& counts = result_.counts;
    if (std::max({counts.positions, counts.uvs, counts.normals, counts.indices}) <= maxIndices_) {
      return;
    }
    error(0, fmt::format("too large: {} vertices, {} triangle corners, at most {} of each are "
                         "possible",
                         counts.positions, counts.indices, maxIndices_));
  }

  Lines lines_;
  std::uint64_t maxIndices_;
  CheckResult result_;
  std::vector<Fault> faults_;
  std::vector<Forward> forward_;
  std::uint64_t unknown_ = 0;
};

}  // namespace

CheckResult check(std::string& text, std::uint64_t maxIndices) {
  if (const std::size_t nul = text.find('\0'); nul != std::string::npos) {
    const std::size_t line = Lines(text).lineOf(nul);
    return {{}, {{line, "a NUL byte, expected a text file"}}, {}};
  }
  return Checker(text, maxIndices).run();
}

}  // namespace laver::obj
