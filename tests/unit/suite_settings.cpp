// Settings of scenes that are tests: SCENE.test.json.
#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/suite/settings.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

class SuiteSettings : public testing::Test {
 protected:
  suite::Settings read(const std::string& text) {
    return suite::readSettings(folder_.write("a.test.json", text), check_);
  }
  /// The errors, without the folder.
  std::string errors(const std::string& text) {
    try {
      read(text);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::Scene);
      return folder_.withoutPath(error.what());
    }
    return "none";
  }
  TemporaryFolder folder_;
  suite::CheckOptions check_ = [](const std::vector<std::string>& options) {
    if (options.front() == "--sampler=wrong") throw Error(ExitCode::Usage, "no such sampler");
  };
};

TEST_F(SuiteSettings, HaveADefaultBoundAndNoOptions) {
  const suite::Settings settings = read("{}");
  EXPECT_EQ(settings.bound.metric, "p99");
  EXPECT_EQ(settings.bound.tolerance, 1e-3);
  EXPECT_EQ(settings.bound.maxShare, std::nullopt);
  EXPECT_TRUE(settings.options.empty());
}

TEST_F(SuiteSettings, BecomeABoundAndOptionsOfARender) {
  const suite::Settings settings = read(
      "{\"metric\": \"flip\", \"tolerance\": 0.25, \"maxShare\": 0.5, \"samples\": 8,\n"
      "\"seed\": -3, \"size\": \"4x3\", \"layers\": [\"depth\", \"uv\"], \"noriCompat\": true,"
      "\"integrator\": [\"ao\", \"mine.glsl\"]}");
  EXPECT_EQ(settings.bound.metric, "flip");
  EXPECT_EQ(settings.bound.tolerance, 0.25);
  EXPECT_EQ(settings.bound.maxShare, 0.5);
  EXPECT_EQ(
      settings.options,
      (std::vector<std::string>{"--spp=8", "--seed=-3", "--size=4x3", "--layers=depth,uv",
                                "--nori-compat", "--integrator=ao," + folder_.path("mine.glsl")}));
}

TEST_F(SuiteSettings, UnknownKeysHaveAPositionAndTheNearestName) {
  EXPECT_EQ(errors("{\"seed\": 1,\n  \"layers\": [\"uv\"], \"smaples\": 3}"),
            "a.test.json:2:21: error: unknown key \"smaples\", expected \"metric\", \"tolerance\", "
            "\"maxShare\", \"significance\", \"pass\", \"samples\", \"seed\", \"size\", \"crop\", "
            "\"integrator\", \"sampler\", "
            "\"filter\", \"layers\", \"error\", \"dialect\" or \"noriCompat\" (nearest: "
            "\"samples\")");
  EXPECT_EQ(
      errors("{\"a\\\\\\\"\\\\\": {\"seed\": 1}}").rfind("a.test.json:1:2: error: unknown", 0), 0U);
}

TEST_F(SuiteSettings, AllErrorsAreReported) {
  EXPECT_EQ(errors("{\n\"seed\": \"a\",\n\"tolerance\": -1, \"maxShare\" :\n 2,\n\"sampler\": "
                   "\"wrong\", \"samples\": 2, \"samples\": 2}"),
            "a.test.json:2:9: error: \"seed\": expected a number\n"
            "a.test.json:3:14: error: \"tolerance\": expected a number of 0 or more\n"
            "a.test.json:4:2: error: \"maxShare\": expected a number from 0 to 1\n"
            "a.test.json:5:12: error: \"sampler\": no such sampler\n"
            "a.test.json:5:35: error: \"samples\" is given twice");
  EXPECT_EQ(errors("{\"metric\": \"p98\", \"tolerance\": 1}").rfind("a.test.json:1:12: error: ", 0),
            0U);
}

TEST_F(SuiteSettings, AMetricNeedsATolerance) {
  EXPECT_EQ(errors("{\n \"metric\": \"rmse\"}"),
            "a.test.json:2:2: error: a \"metric\" needs a \"tolerance\"");
}

TEST_F(SuiteSettings, NoiseRendersVariancesAndHasItsOwnLimits) {
  const suite::Settings defaults = read("{\"metric\": \"noise\"}");
  ASSERT_TRUE(defaults.noise);
  EXPECT_EQ(defaults.noise->significance, 0.01);
  EXPECT_EQ(defaults.noise->pass, 0.9975);
  EXPECT_EQ(defaults.options, std::vector<std::string>{"--layers=variance"});
  const suite::Settings given = read(
      "{\"pass\": 1, \"significance\": 0.05, \"metric\": \"noise\", \"layers\": [\"uv\", "
      "\"depth\"]}");
  EXPECT_EQ(given.noise->significance, 0.05);
  EXPECT_EQ(given.noise->pass, 1.0);
  EXPECT_EQ(given.options, std::vector<std::string>{"--layers=uv,depth,variance"});
  EXPECT_EQ(read("{\"metric\": \"noise\", \"layers\": \"variance\"}").options,
            std::vector<std::string>{"--layers=variance"});
  EXPECT_FALSE(read("{\"metric\": \"p99\", \"tolerance\": 1}").noise);
}

TEST_F(SuiteSettings, KeysOfNoiseAndOfOtherMetricsDoNotMix) {
  EXPECT_EQ(errors("{\"metric\": \"noise\",\n \"tolerance\": 1}"),
            "a.test.json:2:2: error: \"tolerance\" is not for the metric \"noise\"");
  EXPECT_EQ(errors("{\"pass\": 1}"),
            "a.test.json:1:2: error: \"pass\" is for the metric \"noise\"");
  EXPECT_EQ(errors("{\"metric\": \"noise\", \"significance\": 0}"),
            "a.test.json:1:37: error: \"significance\": expected a number between 0 and 1");
}

TEST_F(SuiteSettings, TextThatIsNoJsonHasAPosition) {
  EXPECT_EQ(errors("{\"seed\": 1,\n \"size\" 3}").rfind("a.test.json:2:9: error: ", 0), 0U)
      << errors("{\"seed\": 1,\n \"size\" 3}");
  EXPECT_EQ(errors("").rfind("a.test.json:1:1: error: ", 0), 0U) << errors("");
  EXPECT_EQ(errors("[1]"), "a.test.json:1:1: error: expected an object, { ... }");
  EXPECT_EQ(errors("{\"seed\": 1e999}").rfind("a.test.json:1:1", 0), 0U);
  EXPECT_NE(errors("{\"\xff\": 1}"), "none");
}

}  // namespace
}  // namespace laver::test
