#include "scene/user_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace laver {
namespace {

bool isNameCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace

std::optional<std::string> userText(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  std::ifstream in(file, std::ios::binary);
  if (!in) return {};
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::string userFileName(std::string_view type) {
  constexpr std::size_t kMaxFileName = 255;  // of common file systems
  const std::string file = std::string(type) + ".glsl";
  return isGlslName(type) && file.size() <= kMaxFileName ? file : std::string();
}

bool isGlslName(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), isNameCharacter);
}

}  // namespace laver
