#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>

#include "lab/scratch.h"

namespace laver::test {

/// An empty folder that is removed with the object.
class TemporaryFolder {
 public:
  const std::filesystem::path& path() const { return scratch_.path(); }
  std::string path(const std::string& name) const { return (path() / name).string(); }

  /// Writes a file, creates its subfolders, and returns its path.
  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path() / name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// A text without the folder in it.
  std::string withoutPath(std::string text) const {
    const std::string before = path().string() + "/";
    for (std::size_t at; (at = text.find(before)) != std::string::npos;)
      text.erase(at, before.size());
    return text;
  }

  /// Names of all entries, including hidden ones.
  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path()))
      names.insert(entry.path().filename().string());
    return names;
  }

 private:
  Scratch scratch_;
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace laver::test
