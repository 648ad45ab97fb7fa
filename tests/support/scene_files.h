#pragma once
#include <gtest/gtest.h>

#include <string>

#include "core/error.h"
#include "scene/scene.h"
#include "support/temporary_folder.h"

namespace laver::test {

/// A folder for a scene and its files.
class SceneFiles : public TemporaryFolder {
 public:
  /// Removes the folder's path from a text, so that tests can state whole messages.
  std::string plain(std::string text) const {
    const std::string prefix = path().string() + "/";
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

}  // namespace laver::test
