#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "scene/scene.h"

namespace laver::scene_test {

/// A folder of its own for a test's files, gone with the object.
class Files {
 public:
  Files() {
    static std::atomic<int> count{0};
    folder_ = std::filesystem::temp_directory_path() /
              ("laver-scene-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(folder_);
  }
  ~Files() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }

  /// Text with the folder's name taken out, so that tests can state whole messages.
  std::string plain(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at; (at = text.find(prefix)) != std::string::npos;)
      text.erase(at, prefix.size());
    return text;
  }

  LoadedScene load(const std::string& xml, const SceneOverrides& overrides = {}) const {
    return loadScene(write("f.xml", xml), overrides);
  }

  /// The errors of a scene, one line each; empty if it loads.
  std::string errors(const std::string& xml, const SceneOverrides& overrides = {}) const {
    try {
      load(xml, overrides);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::Scene);
      return plain(error.what());
    }
    return {};
  }

  /// The warnings of a scene that loads, one line each.
  std::string warnings(const std::string& xml, const SceneOverrides& overrides = {}) const {
    std::string lines;
    for (const std::string& line : load(xml, overrides).warnings) {
      lines += (lines.empty() ? "" : "\n") + plain(line);
    }
    return lines;
  }

 private:
  std::filesystem::path folder_;
};

inline const char* const kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// A scene around some tags.
inline std::string scene(const std::string& inside, const std::string& integrator = "normals") {
  return "<scene><integrator type=\"" + integrator + "\"/>\n" + inside + "\n</scene>";
}

/// A mesh of kTriangle's file around some tags.
inline std::string mesh(const std::string& inside = "") {
  return "<mesh type=\"obj\"><string name=\"filename\" value=\"t.obj\"/>" + inside + "</mesh>";
}

inline SceneOverrides with(const IntegratorRow& integrator) {
  SceneOverrides overrides;
  overrides.integrator = {&integrator};
  return overrides;
}

}  // namespace laver::scene_test
