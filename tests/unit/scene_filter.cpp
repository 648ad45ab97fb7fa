// Overriding the scene's reconstruction filter, as --filter does.
#include "support/scene_files.h"

namespace laver::test {
namespace {

Filter filterWith(const FilterRow* kind, const char* rfilter) {
  const SceneFiles files;
  SceneOverrides overrides;
  overrides.filter = kind;
  return files
      .load(scene(std::string("<camera type=\"perspective\">") + rfilter + "</camera>"), overrides)
      .scene.filter;
}

TEST(SceneFilter, AnOverrideHasTheDefaultsOfItsKind) {
  constexpr const char* kOwn =
      "<rfilter type=\"gaussian\"><float name=\"radius\" value=\"3\"/></rfilter>";
  EXPECT_EQ(filterWith(&filters::gaussian, kOwn).radius, 3.0);  // the scene's own
  EXPECT_EQ(filterWith(&filters::mitchell, kOwn).row, &filters::mitchell);
  EXPECT_EQ(filterWith(&filters::mitchell, kOwn).radius, 2.0);
  EXPECT_EQ(filterWith(&filters::tent, kOwn).radius, 1.0);
  EXPECT_EQ(filterWith(&filters::box, "").radius, 0.5);
}

TEST(SceneFilter, OneThatReachesFewSamplesIsWarnedOf) {
  const SceneFiles files;
  const auto warnings = [&](const std::string& name, const std::string& value, int samples) {
    return files.warnings(
        scene("<sampler type=\"independent\"><integer name=\"sampleCount\" value=\"" +
              std::to_string(samples) +
              "\"/></sampler>\n<camera type=\"perspective\">"
              "<rfilter type=\"gaussian\"><float name=\"" +
              name + "\" value=\"" + value + "\"/></rfilter></camera>"));
  };
  EXPECT_EQ(
      warnings("radius", "0.01", 1),
      "f.xml:3:29: warning: the filter \"gaussian\" reaches 0.04 % of a pixel's samples: about "
      "100 % of the pixels get none and stay black");
  EXPECT_NE(warnings("stddev", "0.001", 16), "") << "weights beyond 13 deviations are 0 in floats";
  EXPECT_EQ(warnings("radius", "0.4", 64), "");
  EXPECT_EQ(warnings("radius", "0.5", 1), "");
}

TEST(SceneFilter, NamesAndDefaultsAreTheXmls) {
  const SceneFiles files;
  for (const char* name : {"gaussian", "mitchell", "tent", "box"}) {
    const FilterRow* row = rowCalled(filterRows(), name);
    ASSERT_NE(row, nullptr);
    EXPECT_STREQ(row->name, name);
    const Filter filter = filterOf(*row);
    const Filter read = files
                            .load(scene("<camera type=\"perspective\"><rfilter type=\"" +
                                        std::string(name) + "\"/></camera>"))
                            .scene.filter;
    EXPECT_EQ(read.row, row);
    EXPECT_EQ(read.radius, filter.radius);
    EXPECT_EQ(read.stddev, filter.stddev);
  }
  EXPECT_EQ(rowCalled(filterRows(), "sinc"), nullptr);
}

}  // namespace
}  // namespace laver::test
