#include "scene/encoding.h"

#include <fmt/format.h>
#include <iconv.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <new>
#include <string_view>

namespace laver::xml {
namespace {

using namespace std::string_view_literals;

/// The encoding of texts whose characters have two or four bytes; empty of others.
std::string wideEncoding(std::string_view bytes) {
  struct Start {
    std::string_view mark, bracket;
    const char* name;
  };
  // The mark of 32 bits begins as that of 16 bits does.
  constexpr std::array kStarts = {Start{"\0\0\xFE\xFF"sv, "\0\0\0<"sv, "UTF-32BE"},
                                  Start{"\xFF\xFE\0\0"sv, "<\0\0\0"sv, "UTF-32LE"},
                                  Start{"\xFE\xFF"sv, "\0<"sv, "UTF-16BE"},
                                  Start{"\xFF\xFE"sv, "<\0"sv, "UTF-16LE"}};
  for (const Start& start : kStarts)
    if (bytes.starts_with(start.mark) || bytes.starts_with(start.bracket)) return start.name;
  return {};
}

/// What <?xml encoding="..."?> says; empty where there is none.
std::string declaredEncoding(std::string_view bytes) {
  if (!bytes.starts_with("<?xml")) return {};
  const std::string_view declaration = bytes.substr(0, bytes.find("?>"));
  const std::size_t key = declaration.find("encoding");
  if (key == std::string_view::npos) return {};
  const std::size_t open = declaration.find_first_of("\"'", key);
  if (open == std::string_view::npos) return {};
  const std::size_t close = declaration.find(declaration[open], open + 1);
  if (close == std::string_view::npos) return {};
  return std::string(declaration.substr(open + 1, close - open - 1));
}

/// Whether one-byte characters need no conversion: ASCII, or what programs write that declare the
/// encoding of their own strings (UTF-16) and save UTF-8.
bool isUtf8(std::string_view bytes, std::string_view encoding) {
  const auto isAscii = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  const auto startsWith = [&](std::string_view prefix) {
    return std::ranges::equal(encoding.substr(0, prefix.size()), prefix,
                              [](char a, char b) { return (a & ~0x20) == (b & ~0x20); });
  };
  return encoding.empty() || startsWith("UTF") || startsWith("UCS") ||
         std::all_of(bytes.begin(), bytes.end(), isAscii);
}

class Converter {
 public:
  explicit Converter(const std::string& from) : handle_(::iconv_open("UTF-8", from.c_str())) {}
  ~Converter() {
    if (*this) ::iconv_close(handle_);
  }
  Converter(const Converter&) = delete;
  Converter& operator=(const Converter&) = delete;

  explicit operator bool() const { return reinterpret_cast<std::intptr_t>(handle_) != -1; }

  /// Appends to `text`; the number of bytes that could be converted.
  std::size_t convert(std::string& bytes, std::string& text) {
    char* from = bytes.data();
    std::size_t left = bytes.size();
    std::array<char, 1 << 14> block;
    while (left > 0) {
      char* to = block.data();
      std::size_t room = block.size();
      const bool failed =
          ::iconv(handle_, &from, &left, &to, &room) == static_cast<std::size_t>(-1);
      const bool full = failed && errno == E2BIG;
      text.append(block.data(), to);
      if (failed && !full) break;
    }
    return bytes.size() - left;
  }

 private:
  iconv_t handle_;
};

}  // namespace

FileText utf8Of(std::string bytes) {
  std::string encoding = wideEncoding(bytes);
  if (encoding.empty()) {
    encoding = declaredEncoding(bytes);
    if (isUtf8(bytes, encoding)) return {std::move(bytes), {}};
  }
  // What comes behind a slash would be an option.
  Converter converter(encoding.find('/') == std::string::npos ? encoding : "?");
  if (!converter)
    return {{}, fmt::format("its encoding {} is not known, expected UTF-8", inQuotes(encoding))};
  FileText result;
  const std::size_t converted = converter.convert(bytes, result.text);
  if (converted < bytes.size())
    return {{}, fmt::format("its encoding is {}, but not at byte {}", encoding, converted)};
  return result;
}

}  // namespace laver::xml
