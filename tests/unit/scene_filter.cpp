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
