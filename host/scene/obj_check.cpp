#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>

#include "scene/numbers.h"
#include "scene/obj.h"
#include "scene/text_source.h"

namespace laver::obj {
namespace {

constexpr std::size_t kMaxErrors = 10;
constexpr std::array<const char*, 3> kKinds = {"vertex", "texture coordinate", "normal"};

// Walks the lines of an OBJ text that hold data, split into words. Lines end with LF, CR LF or CR.
// What tinyobjloader does not know is blanked in place: a byte order mark, comments behind data,
// and the backslash and line end by which a line of data continues in the next.
class Lines {
 public:
  explicit Lines(std::string text) : text_(std::move(text)) {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.replace(0, 3, "   ");
  }

  // Goes to the next line that has words; false at the end.
  bool next() {
    words_.clear();
    while (words_.empty() && nextBegin_ < text_.size()) {
      begin_ = nextBegin_;
      const std::size_t end = joinedLineEnd();
      split(end);
      nextBegin_ = end + 1;
    }
    return !words_.empty();
  }

  // The words of the line, the statement's name first.
  const std::vector<std::string_view>& words() const { return words_; }
  std::size_t offset() const { return begin_; }
  std::size_t offsetOf(std::string_view word) const {
    return static_cast<std::size_t>(word.data() - text_.data());
  }

  // Overwrites a word by a text that is not longer.
  void replace(std::string_view word, std::string_view text) {
    const auto place = text_.begin() + static_cast<std::ptrdiff_t>(offsetOf(word));
    std::fill_n(std::copy(text.begin(), text.end(), place), word.size() - text.size(), ' ');
  }

  // The number of the line at an offset, from 1, as the original text counts them. Slow.
  std::size_t lineOf(std::size_t offset) const {
    std::size_t line = 1;
    for (std::size_t i = 0; i < offset && i < text_.size(); ++i) {
      const bool crLf = text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n';
      if (text_[i] == '\n' || (text_[i] == '\r' && !crLf)) ++line;
    }
    const auto before = [&](std::size_t join) { return join < offset; };
    return line + static_cast<std::size_t>(std::count_if(joins_.begin(), joins_.end(), before));
  }

  std::string takeText() && { return std::move(text_); }

 private:
  std::size_t lineEnd(std::size_t from) const {
    while (from < text_.size() && text_[from] != '\n' && text_[from] != '\r') ++from;
    return from;
  }

  std::size_t joinedLineEnd() {
    std::size_t end = lineEnd(begin_);
    if (end == begin_ || end == text_.size() || text_[end - 1] != '\\') return end;
    // Names of other statements may end in a backslash, and so may comments.
    const std::size_t first = text_.find_first_not_of(" \t", begin_);
    if (text_[first] != 'v' && text_[first] != 'f') return end;
    const auto hasComment = [&] {
      return std::string_view(text_).substr(begin_, end - begin_).find('#') != std::string::npos;
    };
    while (end < text_.size() && text_[end - 1] == '\\' && !hasComment()) {
      const bool crLf = text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n';
      joins_.push_back(end);
      text_[end - 1] = text_[end] = ' ';
      if (crLf) text_[end + 1] = ' ';
      end = lineEnd(end);
    }
    return end;
  }

  void split(std::size_t end) {
    for (std::size_t i = begin_; i < end;) {
      if (text_[i] == ' ' || text_[i] == '\t') {
        ++i;
        continue;
      }
      if (text_[i] == '#') {
        std::fill_n(text_.begin() + static_cast<std::ptrdiff_t>(i), end - i, ' ');
        return;
      }
      const std::size_t start = i;
      while (i < end && text_[i] != ' ' && text_[i] != '\t' && text_[i] != '#') ++i;
      words_.push_back(std::string_view(text_).substr(start, i - start));
    }
  }

  std::string text_;
  std::size_t begin_ = 0;
  std::size_t nextBegin_ = 0;
  std::vector<std::size_t> joins_;  // offsets of blanked line ends
  std::vector<std::string_view> words_;
};

class Checker {
 public:
  Checker(std::string text, std::uint64_t maxIndices)
      : lines_(std::move(text)), maxIndices_(maxIndices) {}

  Checked run() && {
    while (!full() && lines_.next()) checkLine();
    checkForwardIndices();
    checkLimits();
    if (unknown_ > 1) {
      result_.warnings.back().message +=
          fmt::format(", and so are {} more lines of unknown kinds", unknown_ - 1);
    }
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
  // An index beyond what was read before it; later lines may reach it.
  struct ForwardIndex {
    std::size_t offset;
    std::size_t kind;  // of kKinds
    std::int64_t index;
  };

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
      if (unknown_++ > 0) return;
      result_.warnings.push_back(
          {lines_.lineOf(lines_.offset()),
           fmt::format("unknown statement {} is ignored", xml::inQuotes(statement))});
    }
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

  // tinyobjloader makes NaN of 0e400, overflows in the exponent of 1e-9999999999, and loses what
  // hundreds of digits add up to. The shortest form of a double has at most 24 characters.
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

  // Removes an index from the front of `rest`; false if there is none.
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

  void checkForwardIndices() {
    for (const ForwardIndex& f : forward_) {
      if (f.index <= countOf(f.kind)) continue;
      error(f.offset, fmt::format("{} index {} is out of range, the file has {}", kKinds[f.kind],
                                  f.index, countOf(f.kind)));
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
  std::vector<ForwardIndex> forward_;
  std::uint64_t unknown_ = 0;
};

}  // namespace

Checked check(std::string text, std::uint64_t maxIndices) {
  if (const std::size_t nul = text.find('\0'); nul != std::string::npos) {
    const std::size_t line = Lines(std::move(text)).lineOf(nul);
    return {{}, {}, {{line, "a NUL byte, expected a text file"}}, {}};
  }
  return Checker(std::move(text), maxIndices).run();
}

}  // namespace laver::obj
