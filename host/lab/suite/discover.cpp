#include "lab/suite/discover.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>
#include <set>
#include <string_view>

#include "core/error.h"
#include "scene/test_file.h"

namespace laver::suite {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScene = ".xml", kSettings = ".test.json", kExr = ".expected.exr",
                           kPng = ".expected.png";
constexpr std::array kEndings = {kScene, kSettings, kExr, kPng};

/// For each path without its ending, relative to the folder, the endings that exist.
using Groups = std::map<std::string, std::set<std::string_view>>;

Groups groupsOf(const fs::path& folder) {
  Groups groups;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code none;
    if (fs::is_directory(entry->path(), none)) continue;
    const std::string name = entry->path().lexically_relative(folder).generic_string();
    for (const std::string_view ending : kEndings)
      if (name.ends_with(ending))
        groups[name.substr(0, name.size() - ending.size())].insert(ending);
  }
  if (error)
    throw Error(ExitCode::Usage, fmt::format("the folder \"{}\" cannot be read: {}",
                                             folder.string(), error.message()));
  return groups;
}

fs::path pathOf(const fs::path& folder, const std::string& stem, std::string_view ending) {
  return folder / (stem + std::string(ending));
}

/// Why files that belong together are no test that can run.
std::string problemOf(const Test& test, const std::set<std::string_view>& endings) {
  if (!endings.contains(kScene))
    return fmt::format("there is {}, but no scene", fmt::join(endings, " and "));
  if (test.kind == Test::Kind::Hypothesis && endings.size() > 1)
    return "a file whose root is <test> has neither settings nor an expected picture";
  return {};
}

}  // namespace

std::vector<Test> discover(const fs::path& folder) {
  std::error_code none;
  if (!fs::is_directory(folder, none))
    throw Error(ExitCode::Usage, fmt::format("\"{}\" is no folder", folder.string()));
  std::vector<Test> tests;
  for (const auto& [stem, endings] : groupsOf(folder)) {
    Test test{.name = stem + std::string(kScene), .file = pathOf(folder, stem, kScene)};
    if (endings.contains(kScene) && isTestFile(test.file.string()))
      test.kind = Test::Kind::Hypothesis;
    else if (endings.size() == 1 && endings.contains(kScene))
      continue;
    if (endings.contains(kSettings)) test.settings = pathOf(folder, stem, kSettings);
    const bool onlyPng = endings.contains(kPng) && !endings.contains(kExr);
    test.expected = pathOf(folder, stem, onlyPng ? kPng : kExr);
    test.problem = problemOf(test, endings);
    tests.push_back(std::move(test));
  }
  if (tests.empty())
    throw Error(ExitCode::Usage,
                fmt::format("no test in \"{}\": expected SCENE.xml with SCENE.expected.exr or "
                            "SCENE.test.json beside it, or a file whose root is <test>",
                            folder.string()));
  return tests;
}

}  // namespace laver::suite
