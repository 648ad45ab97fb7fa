#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace laver {

/// Collects lines of GLSL.
class Text {
 public:
  template <class... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    text_ += fmt::format(format, std::forward<Args>(args)...);
    text_ += '\n';
  }
  void flag(const char* name, bool value) { line("const bool {} = {};", name, value); }
  void number(const char* name, std::uint32_t value) { line("const uint {} = {}u;", name, value); }
  void include(std::string_view path) { line("#include \"{}\"", path); }
  void append(std::string_view text) { text_ += text; }
  /// A user's own text: errors name its file and lines.
  void user(const std::string& file, const std::string& own) {
    line("#line 1 \"{}\"", file);
    append(own);
    line("");
  }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

}  // namespace laver
