#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace laver::xml {

/// A text with its file name, to turn byte offsets into places a reader can go to. A byte order
/// mark is left out.
class TextSource {
 public:
  TextSource(std::string file, std::string text);

  const std::string& file() const { return file_; }
  const std::string& text() const { return text_; }

  /// "file:line:column" of a byte offset, both from 1; a column is a UTF-8 character.
  std::string where(std::size_t offset) const;
  /// The line of a byte offset, from 1. Ends of line are LF, CR LF and CR.
  std::size_t line(std::size_t offset) const;

 private:
  std::string file_;
  std::string text_;
  std::vector<std::size_t> lineStarts_;
};

/// The bytes of a file, or why there are none.
struct FileText {
  std::string text;
  std::string problem;  ///< empty: read; else "no such file", "is a folder", ...
};

/// Reads a whole file. Throws nothing but std::bad_alloc.
FileText readFile(const std::string& file);

/// A name as messages show it: quoted, cut at 60 bytes, control characters as '?'.
std::string inQuotes(std::string_view name);

}  // namespace laver::xml
