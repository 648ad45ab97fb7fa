#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace laver::suite {

/// A scene with a picture or settings beside it, or a file whose root is <test>.
struct Test {
  enum class Kind { Picture, Hypothesis };
  std::string name;  ///< path of the .xml file relative to the folder
  Kind kind = Kind::Picture;
  std::filesystem::path file;      ///< the .xml file
  std::filesystem::path settings;  ///< NAME.test.json; empty if there is none
  std::filesystem::path expected;  ///< NAME.expected.exr, or .png if only that exists
  std::string problem;             ///< why it cannot run; empty if it can
};

/// All tests of a folder and its subfolders, in the order of their names. Throws Error(Usage) if
/// it is no folder, cannot be read or has no test.
std::vector<Test> discover(const std::filesystem::path& folder);

}  // namespace laver::suite
