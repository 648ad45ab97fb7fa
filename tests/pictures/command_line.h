#pragma once
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>

#include "pictures/child.h"
#include "support/temporary_folder.h"
#include "support/test_device.h"

namespace laver::test {

namespace fs = std::filesystem;

struct Outcome {
  int code;
  std::string out, err;
};

/// An empty folder in which laver runs.
class CommandLine : public testing::Test, protected TemporaryFolder {
 protected:
  /// Runs `laver ARGUMENTS` in the test's folder, preceded by `variables` (or limits) and followed
  /// by `redirections`. $device in the arguments is the test device.
  Outcome laver(const std::string& arguments, const std::string& variables = "",
                const std::string& redirections = "") {
    const std::string command = "device='" + testDevice() + "'; cd " + folder_.string() + " && " +
                                variables + " timeout --foreground -s KILL " +
                                std::to_string(kLongestRun) + " '" LAVER_BINARY "' " + arguments +
                                " >out.txt 2>err.txt " + redirections;
    const int status = std::system(command.c_str());
    return {WEXITSTATUS(status), contents(folder_ / "out.txt"), contents(folder_ / "err.txt")};
  }
  /// Names of all entries, including hidden ones, except the two that laver() makes.
  std::set<std::string> files() const {
    std::set<std::string> names = TemporaryFolder::names();
    names.erase("out.txt");
    names.erase("err.txt");
    return names;
  }
  static int lines(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  }

  const fs::path folder_ = TemporaryFolder::path();
};

/// The hand-out's first scene.
inline constexpr const char* kFirstScene =
    "<scene>\n  <integrator type=\"normals\">\n"
    "    <string name=\"myProperty\" value=\"Hello!\"/>\n  </integrator>\n  <camera "
    "type=\"perspective\"/>\n</scene>\n";

}  // namespace laver::test
