#include <gtest/gtest.h>

#include <cstdlib>

#include "bench/report.h"
#include "core/error.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace laver::bench {
namespace {

Report someReport() {
  Report report({{"date", "2026-01-02"}, {"machine", "a machine"}});
  report.section("Rays", {{"rays", 2000}});
  report.timing("laver", {0.004, 0.002, 0.003}, 3000);
  report.timing("other", {0.006}, 3000, 0.003);
  report.figure("other / laver", 2.0, "");
  return report;
}

TEST(BenchReport, ReplacesTheTablesOfADocumentAndKeepsItsText) {
  const test::TemporaryFolder folder;
  const std::string file = folder.path("README.md");
  std::ofstream(file) << "# Speed\n\n<!-- figures -->\nold\n";
  someReport().saveMarkdown(file);
  const std::string text = test::contents(file);
  EXPECT_EQ(text.rfind("# Speed\n\n<!-- figures -->\n", 0), 0U) << text;
  EXPECT_EQ(text.find("old"), std::string::npos);
  for (const char* line :
       {"| date | 2026-01-02 |\n", "| machine | a machine |\n", "| other / laver | 2 |\n",
        "### Rays\n\nrays: 2000\n", "| laver | 3.00 | 2.50 to 3.50 | 1 |  |\n",
        "| other | 6.00 | 6.00 to 6.00 | 0.5 | 2.00 |\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  someReport().saveMarkdown(file);
  EXPECT_EQ(test::contents(file), text);
}

TEST(BenchReport, DoesNotChangeADocumentWithoutAPlaceForTables) {
  const test::TemporaryFolder folder;
  const std::string file = folder.path("README.md");
  std::ofstream(file) << "# Speed\n";
  test::expectError(ExitCode::Output, "has no line", [&] { someReport().saveMarkdown(file); });
  EXPECT_EQ(test::contents(file), "# Speed\n");
}

TEST(BenchReport, TheDocumentHasAPlaceForTables) {
  const std::string text = test::contents(LAVER_SOURCE_DIR "/tests/bench/README.md");
  EXPECT_NE(text.find("\n<!-- figures -->\n"), std::string::npos);
}

TEST(BenchReport, KeepsEveryTimeInJson) {
  const test::TemporaryFolder folder;
  someReport().saveJson(folder.path("bench.json"));
  const auto json = nlohmann::json::parse(std::ifstream(folder.path("bench.json")));
  EXPECT_EQ(json["sections"][0]["timings"][0]["seconds"].size(), 3U);
  EXPECT_EQ(json["sections"][0]["timings"][1]["ratio"], 2.0);
  EXPECT_EQ(json["about"]["machine"], "a machine");
}

TEST(Bench, ShortRunFillsItsDocument) {
  const test::TemporaryFolder folder;
  const std::string file = folder.path("README.md");
  std::ofstream(file) << "<!-- figures -->\n";
  const std::string command =
      "'" LAVER_BENCH "' --short --markdown '" + file + "' >" + folder.path("out.txt") + " 2>&1";
  ASSERT_EQ(std::system(command.c_str()), 0) << test::contents(folder.path("out.txt"));
  const std::string text = test::contents(file);
  for (const char* part :
       {"| date |", "| Embree |", "### Render: torus", "### Traversal only: bunny",
        "### Tree: bunny", "### OBJ file: bunny", "### Process: laver"})
    EXPECT_NE(text.find(part), std::string::npos) << part << text;
}

}  // namespace
}  // namespace laver::bench
