// Adaptive sampling: the bits do not depend on tiling, and borders between sample counts are right.
#include "pictures/adaptive.h"

#include <cstdlib>

#include "image/io.h"
#include "pictures/command_line.h"
#include "pictures/explain.h"
#include "reference/filter.h"
#include "reference/reference.h"

namespace laver::test {
namespace {

void expectSame(const Adaptive& a, const Adaptive& b) {
  EXPECT_EQ(differingFloats(a.image, b.image), 0U);
  EXPECT_EQ(differingFloats(a.stats.samples, b.stats.samples), 0U);
}

TEST(Adaptive, PathsHaveMorePilots) {
  Scene scene = floorScene();
  scene.integrator = {rowCalled(integratorRows(), "path_mis")};
  EXPECT_EQ(renderTo(scene, adaptive()).stats.pilotSamples, 96U * 96U * kPilotsOfPaths);
}

TEST(Adaptive, SameBitsForThreadsBandsPassesTraversalsAndKernels) {
  const Scene scene = floorScene();
  const Adaptive whole = renderTo(scene, adaptive());
  EXPECT_EQ(whole.stats.min, 1U);
  EXPECT_GT(whole.stats.max, 16U);
  EXPECT_EQ(whole.stats.pilotSamples, 96U * 96U * kPilots);

  RenderOptions one = adaptive();
  one.threads = 1;
  ::setenv("LP_NUM_THREADS", "1", 1);
  expectSame(whole, renderTo(scene, one));
  ::setenv("LP_NUM_THREADS", "2", 1);
  expectSame(whole, renderTo(scene, adaptive()));
  ::unsetenv("LP_NUM_THREADS");

  // Passes of four samples of a few rows, then of sixteen samples of a part of the film.
  for (const std::uint64_t slots : {96U * 11 * 4, 96U * 60 * 16}) {
    VulkanOptions cut = onTestDevice();
    cut.samplesInFlight = slots;
    expectSame(whole, renderTo(scene, adaptive(), cut));
  }
  for (const std::string& traversal : traversals())
    expectSame(whole, renderTo(scene, adaptive(), onTestDevice(traversal)));
  VulkanOptions generic = onTestDevice();
  generic.general = generalParts();
  expectSame(whole, renderTo(scene, adaptive(), generic));
}

TEST(Adaptive, LaneAndPacketsAgreeOnEveryFilterAndAnOddFilm) {
  for (const char* name : {"cornell-two-lights.xml", "curved-normals.xml"}) {
    Scene scene = smallScene(name, 61, 32);
    for (const auto& filter : {Filter{&filters::box, 0.5, 0.0, 0.0, 0.0},
                               Filter{&filters::gaussian, 3.7, 1.1, 0.0, 0.0}}) {
      scene.filter = filter;
      const Adaptive whole = renderTo(scene, adaptive());
      for (const std::string& traversal : traversals())
        expectSame(whole, renderTo(scene, adaptive(), onTestDevice(traversal)));
    }
  }
}

void expectCropsOf(const Scene& scene) {
  const Adaptive whole = renderTo(scene, adaptive());
  for (const Crop crop : {Crop{0, 0, 17, 9}, Crop{31, 30, 70, 66}, Crop{61, 61, 62, 62}}) {
    RenderOptions options = adaptive();
    options.crop = crop;
    const Adaptive part = renderTo(scene, options);
    for (int y = crop.y0; y < crop.y1; ++y)
      for (int x = crop.x0; x < crop.x1; ++x) {
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_EQ(part.image.at(x - crop.x0, y - crop.y0, c), whole.image.at(x, y, c));
        ASSERT_EQ(part.stats.samples.at(x - crop.x0, y - crop.y0, 0),
                  whole.stats.samples.at(x, y, 0));
      }
  }
}

TEST(Adaptive, ACropIsCutOutOfTheFullPicture) {
  Scene scene = floorScene();
  expectCropsOf(scene);
  scene.filter = {&filters::gaussian, 4.5, 1.2, 0.0, 0.0};  // reaches beyond a cell
  expectCropsOf(scene);
}

/// A pixel in double precision from the reference's radiances. Each sample weighs one over its
/// pixel's count, or one, which is the error to detect.
glm::dvec3 pixelOf(const Scene& scene, const Reference& reference, const Image& counts, int x,
                   int y, bool byCount, const Judge& judge, bool& decided) {
  const laver::reference::FilterWeights weights(scene.filter, false);
  const int reach = weights.reach();
  glm::dvec3 sum(0.0);
  double total = 0;
  for (int v = std::max(y - reach, 0); v <= std::min(y + reach, counts.height - 1); ++v)
    for (int u = std::max(x - reach, 0); u <= std::min(x + reach, counts.width - 1); ++u) {
      const auto count = static_cast<std::uint32_t>(counts.at(u, v, 0));
      for (std::uint32_t s = 0; s < count; ++s) {
        const glm::dvec2 film(reference.samplePosition(u, v, s));
        const double w = weights(film.x - x - 0.5) * weights(film.y - y - 0.5);
        if (w == 0.0) continue;
        sum += w / (byCount ? count : 1) * reference.radiance(film);
        total += w / (byCount ? count : 1);
        decided = decided && !judge.otherValue(film, glm::dvec2(0.5), 1e-3);
      }
    }
  return sum / total;
}

TEST(Adaptive, EqualsTheReferenceWhereRegionsOfDifferentCountsMeet) {
  const Scene scene = floorScene(64);
  const Adaptive ours = renderTo(scene, adaptive());
  const Reference reference(scene);
  const Judge judge(scene, reference);
  const Image& counts = ours.stats.samples;
  int borders = 0, unweighted = 0, explained = 0;
  for (int y = 3; y < 64; y += 4)
    for (int x = 3; x < 63; x += 4) {
      if (counts.at(x, y, 0) == counts.at(x + 1, y, 0)) continue;
      ++borders;
      const auto distance = [&](bool byCount, bool& decided) {
        const glm::dvec3 wanted = pixelOf(scene, reference, counts, x, y, byCount, judge, decided);
        double largest = 0;
        for (int c = 0; c < 3; ++c)
          largest =
              std::max(largest, std::abs(wanted[c] - static_cast<double>(ours.image.at(
                                                         x, y, static_cast<std::size_t>(c)))));
        return largest;
      };
      bool decided = true, any = true;
      // 1e-4 as for every scene; a larger difference requires a sample at an edge.
      if (distance(true, decided) > 1e-4) {
        EXPECT_FALSE(decided) << x << ' ' << y;
        ++explained;
      }
      if (distance(false, any) > 1e-3) ++unweighted;
    }
  EXPECT_GT(borders, 30);
  EXPECT_LE(explained, borders / 20);
  EXPECT_GT(unweighted, 5);  // the test can fail
}

TEST(Adaptive, StopsBetweenPassesAndDuringThePilots) {
  const Scene scene = floorScene();
  VulkanOptions vulkan = onTestDevice();
  vulkan.samplesInFlight = std::uint64_t{128} * 96 * 16;  // rows are stored in columns of 64
  for (const int passes : {2, kPilots + 1}) {
    RenderOptions options = adaptive();
    StopAfter stop(passes);
    options.observers = {&stop};
    Stats stats;
    const auto [image, reached, dropped] = Renderer(vulkan).render(scene, options, stats);
    const bool decided = passes > kPilots;
    EXPECT_EQ(reached.rows, decided ? 96 : 0);
    EXPECT_EQ(reached.wholeRows, 0);
    EXPECT_EQ(reached.samples, decided ? 16U : 0U);
    EXPECT_EQ(image.at(48, 80, 0) > 0.0F, decided);
    for (const float v : image.pixels) ASSERT_TRUE(std::isfinite(v));
  }
}

class AdaptiveCommand : public CommandLine {};

TEST_F(AdaptiveCommand, WritesTheMapOfSamplesAndReportsStatistics) {
  const std::string scene = (scenesFolder() / "wide-floor.xml").string();
  const Outcome run =
      laver(scene + " --device $device --size 64x64 --spp 18 --error 0.01 -o a.exr --stats");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("adaptive     error 0.01: "), std::string::npos) << run.err;
  EXPECT_EQ(files(), (std::set<std::string>{"a.exr", "a.png"}));
  const Image image = readExr(path("a.exr"));
  const auto channel = std::find(image.channels.begin(), image.channels.end(), "samples");
  ASSERT_NE(channel, image.channels.end());
  std::set<float> counts;
  for (auto i = static_cast<std::size_t>(channel - image.channels.begin()); i < image.pixels.size();
       i += image.channels.size())
    counts.insert(image.pixels[i]);
  EXPECT_EQ(*counts.rbegin(), 16.0F);  // the maximum is a multiple of 4
  EXPECT_EQ(*counts.begin(), 1.0F);
}

TEST_F(AdaptiveCommand, RefusesInvalidOptionsInOneLine) {
  write("scene.xml", kFirstScene);
  for (const char* arguments : {"--error 0", "--error -1", "--error nan", "--error small",
                                "--error 0.01 --spp 3", "--error 0.01 --spp 16 --reference"}) {
    const Outcome run =
        laver(std::string("scene.xml --device $device -o a.exr --quiet ") + arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_NE(run.err.find("--error"), std::string::npos) << run.err;
    EXPECT_LT(run.err.size(), 200U) << run.err;
  }
  EXPECT_EQ(files(), std::set<std::string>{"scene.xml"});
}

}  // namespace
}  // namespace laver::test
