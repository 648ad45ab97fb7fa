// What a chart renders.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "lab/chart/choices.h"

namespace laver::chart {
namespace {

bool has(const std::vector<std::string>& list, const std::string& option,
         const std::string& value) {
  const auto at = std::find(list.begin(), list.end(), option);
  return at != list.end() && at + 1 != list.end() && *(at + 1) == value;
}

TEST(ChartChoices, EverySamplerMeetsEveryFilterOnce) {
  Scene scene;
  scene.filter = filterOf(filters::mitchell);
  const auto choices = choicesFor(scene, {{"embree", "file"}}, {"lane", "packet64"}, 64);
  std::set<std::tuple<std::string, std::uint32_t, double>> seen;
  std::set<std::string> series;
  for (const Choice& choice : choices) {
    EXPECT_LE(choice.samples, 64U);
    EXPECT_TRUE(seen.emplace(nameOf(choice.series), choice.samples, choice.error).second)
        << nameOf(choice.series);
    series.insert(nameOf(choice.series));
    const auto arguments = choice.arguments();
    EXPECT_TRUE(has(arguments, "--filter", choice.series.filter->name));
    EXPECT_TRUE(has(arguments, "--sampler", choice.series.sampler));
    const auto most = choice.series.adaptive ? choice.most : choice.samples;
    EXPECT_TRUE(has(arguments, "--spp", std::to_string(most)));
    EXPECT_EQ(has(arguments, "--error", fmt::format("{}", choice.error)), choice.series.adaptive);
    for (const char* traversal : {"lane", "packet64"})
      EXPECT_EQ(has(arguments, "--traversal", traversal), choice.series.traversal == traversal);
  }
  for (const char* filter : {"box", "tent", "gaussian", "mitchell"}) {
    for (const char* sampler : {"independent", "stratified", "sobol"})
      for (const char* program : {"", "embree, "})
        EXPECT_TRUE(series.count(std::string(program) + sampler + ", " + filter));
  }
  // Adaptively, and by other traversals, with the scene's own filter alone.
  EXPECT_TRUE(series.count("independent adaptive, mitchell"));
  EXPECT_TRUE(series.count("sobol adaptive, mitchell"));
  EXPECT_TRUE(series.count("independent, mitchell, lane"));
  EXPECT_TRUE(series.count("independent, mitchell, packet64"));
  EXPECT_FALSE(series.count("independent, box, lane"));
  EXPECT_EQ(series.size(), 4U * 6U + 4U);
}

TEST(ChartChoices, TheTraversalTakenUnaskedIsNotChartedTwice) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(traversalsBeside("packet32"), (Names{"lane", "packet64"}));
  EXPECT_EQ(traversalsBeside("packet64"), (Names{"lane", "packet32"}));
  EXPECT_EQ(traversalsBeside("lane"), Names{});
}

TEST(ChartChoices, EachProgramsRenderOfAPictureIsMeasuredBesideLavers) {
  Scene scene;
  scene.filter = filterOf(filters::mitchell);
  const auto choices = choicesFor(scene, {{"embree", "file"}, {"old", "file"}}, {"lane"}, 64);
  std::set<std::size_t> seen;
  std::size_t together = 0;
  for (const auto& group : sameButForProgram(choices)) {
    std::set<std::string> programs;
    for (const std::size_t i : group) {
      EXPECT_TRUE(seen.insert(i).second);
      EXPECT_EQ(choices[i].arguments(), choices[group[0]].arguments());
      EXPECT_TRUE(programs.insert(choices[i].series.program).second);
    }
    // Adaptive renders and those of another traversal are laver's alone.
    const Choice& first = choices[group[0]];
    const bool alone = first.series.adaptive || !first.series.traversal.empty();
    EXPECT_EQ(programs.size(), alone ? 1U : 3U) << nameOf(first.series);
    together += alone ? 0U : 1U;
  }
  EXPECT_EQ(seen.size(), choices.size());
  EXPECT_EQ(together, 4U * 3U * 4U);  // filters, samplers, counts of samples
}

TEST(ChartChoices, TheScenesOwnFilterComesFirstAndKeepsItsNumbers) {
  Scene scene;
  scene.filter = {&filters::gaussian, 3.0, 0.7, 0.0, 0.0};
  const auto filters = filtersFor(scene);
  ASSERT_EQ(filters.size(), 4U);
  EXPECT_EQ(filters[0].stddev, 0.7);
  EXPECT_EQ(filters[1].row, &filters::box);
  EXPECT_EQ(filters[1].radius, 0.5);
}

TEST(ChartChoices, AdaptiveOnesAreAskedByTheirError) {
  const Choice choice{{"laver", "sobol", &filters::box, "", true}, 0, 0.005, 32};
  EXPECT_TRUE(has(choice.arguments(), "--error", "0.005"));
  EXPECT_TRUE(has(choice.arguments(), "--spp", "32"));
  EXPECT_EQ(nameOf(choice.series), "sobol adaptive, box");
}

}  // namespace
}  // namespace laver::chart
