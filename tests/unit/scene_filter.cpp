// Another reconstruction filter than the scene's, as --filter asks for.
#include "support/scene_files.h"

namespace laver::test {
namespace {

Filter filterWith(Filter::Kind kind, const char* rfilter) {
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
  EXPECT_EQ(filterWith(Filter::Kind::Gaussian, kOwn).radius, 3.0);  // the scene's own
  EXPECT_EQ(filterWith(Filter::Kind::Mitchell, kOwn).kind, Filter::Kind::Mitchell);
  EXPECT_EQ(filterWith(Filter::Kind::Mitchell, kOwn).radius, 2.0);
  EXPECT_EQ(filterWith(Filter::Kind::Tent, kOwn).radius, 1.0);
  EXPECT_EQ(filterWith(Filter::Kind::Box, "").radius, 0.5);
}

TEST(SceneFilter, NamesAndDefaultsAreTheXmls) {
  const SceneFiles files;
  for (const char* name : {"gaussian", "mitchell", "tent", "box"}) {
    const auto filter = filterFromName(name);
    ASSERT_TRUE(filter);
    EXPECT_STREQ(filterName(filter->kind), name);
    const Filter read = files
                            .load(scene("<camera type=\"perspective\"><rfilter type=\"" +
                                        std::string(name) + "\"/></camera>"))
                            .scene.filter;
    EXPECT_EQ(read.kind, filter->kind);
    EXPECT_EQ(read.radius, filter->radius);
    EXPECT_EQ(read.stddev, filter->stddev);
  }
  EXPECT_FALSE(filterFromName("sinc"));
}

}  // namespace
}  // namespace laver::test
