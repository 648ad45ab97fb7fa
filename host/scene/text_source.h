#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace laver::xml {

/// A text with its file name, which converts byte offsets to positions in an editor. A byte order
/// mark is removed.
class TextSource {
 public:
  TextSource(std::string file, std::string text);

  const std::string& file() const { return file_; }
  const std::string& text() const { return text_; }

  /// "file:line:column" of a byte offset, both from 1; a column is one UTF-8 character.
  std::string where(std::size_t offset) const;
  /// The line of a byte offset, from 1. Lines end with LF, CR LF or CR.
  std::size_t line(std::size_t offset) const;

 private:
  std::string file_;
  std::string text_;
  std::vector<std::size_t> lineStarts_;
};

/// The bytes of a file, or the reason why it cannot be read.
struct FileText {
  std::string text;
  std::string problem;  ///< empty, or "no such file", "is a folder", ...
};

/// Reads a whole file. Throws nothing but std::bad_alloc.
FileText readFile(const std::string& file);

/// A name for messages: quoted, truncated to 60 bytes, control characters as '?'.
std::string inQuotes(std::string_view name);

}  // namespace laver::xml
