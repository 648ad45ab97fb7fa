// Reports on tests of scenes: lines, JUnit, HTML.
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "lab/suite/report.h"

namespace laver::test {
namespace {

using suite::Verdict;

suite::Result resultOf(const std::string& name, Verdict verdict, std::optional<double> figure) {
  suite::Result result;
  result.name = name;
  result.verdict = verdict;
  result.seconds = 0.5;
  if (figure) result.figure = suite::figureOf(*figure, suite::kDefaultBound);
  return result;
}

/// Of each verdict, not in the order of severity, with texts that need escapes.
std::vector<suite::Result> someResults() {
  std::vector<suite::Result> results = {
      resultOf("good.xml", Verdict::Passed, 1e-7),
      resultOf("slight.xml", Verdict::Failed, 2e-3),
      resultOf("near.xml", Verdict::Passed, 9e-4),
      resultOf("a/left.xml", Verdict::Skipped, {}),
      resultOf("a/b/bro\"ken&<.xml", Verdict::Failed, {}),
      resultOf("bad.xml", Verdict::Failed, 0.5),
  };
  results[0].actual = {std::byte{1}, std::byte{2}, std::byte{3}, std::byte{4}};
  results[3].reason = "no device";
  results[4].reason = "x.xml:1:2: error: <&\x01\xff\nanother";
  results[4].output = "warning ]]> <b>\n";
  return results;
}

TEST(SuiteReport, AResultIsOneLine) {
  const auto results = someResults();
  EXPECT_EQ(suite::lineOf(results[0]), "passed   good.xml  0.50 s  p99 1e-07, tolerance 0.001");
  EXPECT_EQ(suite::lineOf(results[3]), "skipped  a/left.xml  0.50 s: no device");
  EXPECT_EQ(suite::lineOf(results[4]),
            "failed   a/b/bro\"ken&<.xml  0.50 s: x.xml:1:2: error: <& \xEF\xBF\xBD (and 1 more)");
  EXPECT_EQ(suite::summaryOf(suite::countsOf(results)), "2 passed, 3 failed, 1 skipped");
}

TEST(SuiteReport, AShareOfPixelsNamesBothNumbers) {
  suite::Result result = resultOf("a.xml", Verdict::Passed, {});
  result.figure = suite::figureOf(0.25, Bound{"max", 0.5, 0.25});
  EXPECT_EQ(suite::lineOf(result),
            "passed   a.xml  0.50 s  share beyond 0.5: 0.25, tolerance 0.25");
  EXPECT_TRUE(result.figure->within);
}

TEST(SuiteReport, NoiseNamesBothTestsAndTheWorseOneCounts) {
  NoiseTest test;
  test.agree = 0.99;
  test.meanP = 0.2;
  test.meanDifference = -0.005;
  test.passed = false;
  const suite::Figure pixels = suite::figureOf(test, {.significance = 0.01, .pass = 0.995});
  EXPECT_EQ(pixels.text, "noise: 99 % of the pixels agree, 99.5 % must; mean -0.5 %, p 0.2");
  EXPECT_FALSE(pixels.within);
  EXPECT_NEAR(pixels.share, 2.0, 1e-9);
  test.agree = 1.0;
  test.meanP = 0.001;
  EXPECT_NEAR(suite::figureOf(test, {.significance = 0.01, .pass = 0.995}).share, 5.0, 1e-9);
}

TEST(SuiteReport, JUnitIsWellFormedAndCounts) {
  const std::string text = suite::junitOf(someResults(), "fol<der");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(text.c_str())) << text;
  const pugi::xml_node suites = document.child("testsuites"), suite = suites.child("testsuite");
  for (const pugi::xml_node node : {suites, suite}) {
    EXPECT_EQ(node.attribute("tests").as_int(), 6);
    EXPECT_EQ(node.attribute("failures").as_int(), 3);
    EXPECT_EQ(node.attribute("skipped").as_int(), 1);
    EXPECT_STREQ(node.attribute("time").value(), "3.000");
  }
  EXPECT_STREQ(suite.attribute("name").value(), "fol<der");
  const auto cases = suite.children("testcase");
  EXPECT_EQ(std::distance(cases.begin(), cases.end()), 6);
  const pugi::xml_node broken = suite.find_child_by_attribute("name", "bro\"ken&<.xml");
  EXPECT_STREQ(broken.attribute("classname").value(), "a/b");
  EXPECT_STREQ(broken.child("failure").attribute("message").value(),
               "x.xml:1:2: error: <& \xEF\xBF\xBD (and 1 more)");
  EXPECT_STREQ(broken.child_value("system-out"), "warning ]]> <b>\n");
  EXPECT_TRUE(suite.find_child_by_attribute("name", "left.xml").child("skipped"));
  EXPECT_FALSE(suite.find_child_by_attribute("name", "good.xml").child("failure"));
}

TEST(SuiteReport, HtmlShowsTheWorstFirstAndEscapes) {
  const std::string html = suite::htmlOf(someResults(), "folder");
  std::size_t last = 0;
  for (const char* name : {"a/b/bro&quot;ken&amp;&lt;.xml", "bad.xml", "slight.xml", "a/left.xml",
                           "near.xml", "good.xml"}) {
    const std::size_t at = html.find(std::string("<h2>") + name);
    ASSERT_NE(at, std::string::npos) << name;
    EXPECT_GT(at, last) << name;
    last = at;
  }
  EXPECT_NE(html.find("src=\"data:image/png;base64,AQIDBA==\""), std::string::npos);
  EXPECT_EQ(html.find("<b>"), std::string::npos);
  EXPECT_EQ(html.find("http"), std::string::npos);
}

}  // namespace
}  // namespace laver::test
