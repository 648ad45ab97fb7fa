// Which files of a folder are tests.
#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/suite/discover.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

std::vector<std::string> namesOf(const std::vector<suite::Test>& tests) {
  std::vector<std::string> names;
  names.reserve(tests.size());
  for (const suite::Test& test : tests) names.push_back(test.name);
  return names;
}

TEST(SuiteDiscover, FindsScenesWithPicturesOrSettingsAndTestFilesInOrder) {
  const TemporaryFolder folder;
  for (const char* scene : {"b.xml", "a.xml", "sub/deep/c.xml", "alone.xml", "p.xml"})
    folder.write(scene, "<scene/>");
  folder.write("b.expected.exr", "");
  folder.write("p.expected.png", "");
  folder.write("a.test.json", "{}");
  folder.write("sub/deep/c.expected.exr", "");
  folder.write("sub/deep/c.expected.png", "");
  folder.write("sub/h.xml", "<test/>");
  folder.write("sub/cut.xml", "<test type=\"ttest\">");
  const auto tests = suite::discover(folder.path());
  EXPECT_EQ(namesOf(tests), (std::vector<std::string>{"a.xml", "b.xml", "p.xml", "sub/cut.xml",
                                                      "sub/deep/c.xml", "sub/h.xml"}));
  for (const suite::Test& test : tests) EXPECT_EQ(test.problem, "") << test.name;
  EXPECT_EQ(tests[0].settings, folder.path("a.test.json"));
  EXPECT_EQ(tests[0].expected, folder.path("a.expected.exr"));
  EXPECT_EQ(tests[1].settings, "");
  EXPECT_EQ(tests[2].expected, folder.path("p.expected.png"));
  EXPECT_EQ(tests[4].expected, folder.path("sub/deep/c.expected.exr"));
  EXPECT_EQ(tests[4].kind, suite::Test::Kind::Picture);
  EXPECT_EQ(tests[3].kind, suite::Test::Kind::Hypothesis);
  EXPECT_EQ(tests[5].kind, suite::Test::Kind::Hypothesis);
}

TEST(SuiteDiscover, FilesWithoutTheirSceneAreAProblem) {
  const TemporaryFolder folder;
  folder.write("renamed.expected.exr", "");
  folder.write("t.xml", "<test/>");
  folder.write("t.test.json", "{}");
  const auto tests = suite::discover(folder.path());
  ASSERT_EQ(tests.size(), 2U);
  EXPECT_EQ(tests[0].problem, "there is .expected.exr, but no scene");
  EXPECT_NE(tests[1].problem, "");
}

TEST(SuiteDiscover, AFolderWithoutTestsIsAnError) {
  const TemporaryFolder folder;
  const auto code = [&](const std::string& where) {
    try {
      suite::discover(where);
    } catch (const Error& error) {
      return error.code();
    }
    return ExitCode::Ok;
  };
  EXPECT_EQ(code(folder.path().string()), ExitCode::Usage);
  folder.write("a.xml", "<scene/>");
  EXPECT_EQ(code(folder.path().string()), ExitCode::Usage);
  EXPECT_EQ(code(folder.path("a.xml")), ExitCode::Usage);
  EXPECT_EQ(code(folder.path("none")), ExitCode::Usage);
  folder.write("a.test.json", "{}");
  EXPECT_EQ(code(folder.path().string()), ExitCode::Ok);
}

}  // namespace
}  // namespace laver::test
