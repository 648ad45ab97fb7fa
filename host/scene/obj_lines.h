#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace laver::obj {

/// Walks the lines of an OBJ text that hold data, cut into words. Lines end with LF, CR LF or CR.
/// What tinyobjloader does not know is blanked in place: a byte order mark, comments behind data,
/// and the backslash and line end by which a line of data goes on in the next.
class Lines {
 public:
  explicit Lines(std::string& text);

  /// Goes to the next line that has words; false at the end.
  bool next();
  /// The words of the line, the statement's name first.
  const std::vector<std::string_view>& words() const { return words_; }
  /// Where the line begins, in bytes.
  std::size_t offset() const { return begin_; }
  /// Where a word begins, in bytes.
  std::size_t offsetOf(std::string_view word) const {
    return static_cast<std::size_t>(word.data() - text_.data());
  }
  /// Puts a text in the place of a word that is as long or longer.
  void replace(std::string_view word, std::string_view text);
  /// The number of the line at an offset, from 1, as the file counted them. Slow.
  std::size_t lineOf(std::size_t offset) const;

 private:
  std::size_t lineEnd(std::size_t from) const;
  std::size_t joinedLineEnd();
  void split(std::size_t end);

  std::string& text_;
  std::size_t begin_ = 0;
  std::size_t nextBegin_ = 0;
  std::vector<std::size_t> joins_;  // offsets of blanked line ends
  std::vector<std::string_view> words_;
};

}  // namespace laver::obj
