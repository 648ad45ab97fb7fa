#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace laver::obj {

/// Iterates over the lines with data of an OBJ text, split into words. Lines end with LF, CR LF or
/// CR. Parts that tinyobjloader does not support are blanked in place: a byte order mark, comments
/// after data, and the backslash and line end that continue a line. A # begins a comment only at
/// the start of a word: -1.#IND is a (malformed) number.
class Lines {
 public:
  explicit Lines(std::string text);

  /// Goes to the next line that has words; false at the end.
  bool next();

  /// The words of the line, the statement's name first.
  const std::vector<std::string_view>& words() const { return words_; }
  std::size_t offset() const { return begin_; }
  /// From 1; of continued lines, the first.
  std::size_t line() const { return line_; }
  std::size_t offsetOf(std::string_view word) const {
    return static_cast<std::size_t>(word.data() - text_.data());
  }

  /// Overwrites a word with a text that is not longer.
  void replace(std::string_view word, std::string_view text);

  /// The line number of an offset, from 1, in the original text. Slow.
  std::size_t lineOf(std::size_t offset) const;

  std::string takeText() && { return std::move(text_); }

 private:
  bool isCrLf(std::size_t at) const;
  std::size_t lineEnd(std::size_t from) const;
  std::size_t joinedLineEnd();
  void split(std::size_t end);

  std::string text_;
  std::size_t begin_ = 0;
  std::size_t nextBegin_ = 0;
  std::size_t line_ = 0, nextLine_ = 1;
  std::vector<std::size_t> joins_;  // offsets of blanked line ends
  std::vector<std::string_view> words_;
};

}  // namespace laver::obj
