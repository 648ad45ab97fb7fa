#include "scene/text_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace laver::xml {

TextSource::TextSource(std::string file, std::string text)
    : file_(std::move(file)), text_(std::move(text)), lineStarts_{0} {
  if (text_.starts_with("\xEF\xBB\xBF")) text_.erase(0, 3);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    const bool crLf = text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n';
    if (text_[i] == '\n' || (text_[i] == '\r' && !crLf)) lineStarts_.push_back(i + 1);
  }
}

std::size_t TextSource::line(std::size_t offset) const {
  const auto next = std::upper_bound(lineStarts_.begin(), lineStarts_.end(), offset);
  return static_cast<std::size_t>(next - lineStarts_.begin());
}

std::string TextSource::where(std::size_t offset) const {
  offset = std::min(offset, text_.size());
  const std::size_t row = line(offset);
  // Bytes 10xxxxxx continue a UTF-8 character.
  const auto begin = text_.begin() + static_cast<std::ptrdiff_t>(lineStarts_[row - 1]);
  const auto end = text_.begin() + static_cast<std::ptrdiff_t>(offset);
  const auto before = std::count_if(
      begin, end, [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; });
  return fmt::format("{}:{}:{}", file_, row, before + 1);
}

FileText readFile(const std::string& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (status.type() == std::filesystem::file_type::not_found) return {{}, "no such file"};
  if (std::filesystem::is_directory(status)) return {{}, "is a folder, expected a file"};
  if (std::filesystem::is_character_file(status)) return {{}, "is a device, expected a file"};
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {{}, fmt::format("cannot be opened: {}", std::strerror(errno))};
  FileText result;
  if (const auto size = std::filesystem::file_size(file, error); !error) result.text.reserve(size);
  for (char block[1 << 16]; stream.read(block, sizeof block), stream.gcount() > 0;) {
    result.text.append(block, static_cast<std::size_t>(stream.gcount()));
  }
  if (stream.bad()) return {{}, "cannot be read"};
  return result;
}

std::string inQuotes(std::string_view name) {
  constexpr std::size_t kMaxLength = 60;
  std::string text(name.substr(0, kMaxLength));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = '?';
  }
  return fmt::format("\"{}{}\"", text, name.size() > kMaxLength ? "..." : "");
}

}  // namespace laver::xml
