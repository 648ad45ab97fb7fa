// What a chart keeps from run to run.
#include <gtest/gtest.h>

#include "lab/chart/errors.h"
#include "lab/chart/fingerprint.h"
#include "lab/chart/kept.h"
#include "lab/chart/truth.h"
#include "unit/image_test_folder.h"
#include "unit/scene_files.h"

namespace laver::chart {
namespace {

using image_test::contents;
using image_test::Folder;

nlohmann::json someValue() {
  return {{"seconds", {1.5, 2.5}}, {"pixels", nlohmann::json::binary({1, 2, 3, 250})}};
}

TEST(ChartKept, GivesBackWhatWasWritten) {
  const Folder folder;
  const Kept kept(folder.file("new/folder"));
  EXPECT_FALSE(kept.read("a"));
  kept.write("a", someValue());
  EXPECT_EQ(*kept.read("a"), someValue());
  EXPECT_FALSE(kept.read("b"));
}

TEST(ChartKept, DamageOfAnyByteOrLengthCountsAsNothing) {
  const Folder folder;
  const Kept kept(folder.file("kept"));
  kept.write("a", someValue());
  const std::string whole = contents(kept.fileOf("a").string());
  const auto replace = [&](const std::string& bytes) {
    std::ofstream(kept.fileOf("a"), std::ios::binary | std::ios::trunc) << bytes;
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string broken = whole;
    broken[i] = static_cast<char>(broken[i] ^ 4);
    replace(broken);
    EXPECT_FALSE(kept.read("a")) << i;
    replace(whole.substr(0, i));
    EXPECT_FALSE(kept.read("a")) << i;
  }
  replace(whole + "x");
  EXPECT_FALSE(kept.read("a"));
  replace(whole);
  EXPECT_TRUE(kept.read("a"));
}

TEST(ChartKept, AnotherKeyInItsFileCountsAsNothing) {
  const Folder folder;
  const Kept kept(folder.file("kept"));
  kept.write("a", someValue());
  std::filesystem::rename(kept.fileOf("a"), kept.fileOf("b"));
  EXPECT_FALSE(kept.read("b"));
}

TEST(ChartKept, AFolderThatCannotBeMadeIsAnError) {
  const Folder folder;
  std::ofstream(folder.file("file")) << "x";
  image_test::expectError(ExitCode::Output, "cannot make the folder",
                          [&] { Kept(folder.file("file/kept")); });
}

TEST(ChartFingerprint, ChangesWithTheSceneAndWithItsMeshes) {
  const scene_test::Files files;
  files.write("t.obj", scene_test::kTriangle);
  const std::string file = files.write("s.xml", scene_test::scene(scene_test::mesh()));
  const std::string first = fingerprintOfScene(file);
  EXPECT_EQ(fingerprintOfScene(file), first);
  files.write("t.obj", std::string(scene_test::kTriangle) + "v 1 1 1\n");
  const std::string second = fingerprintOfScene(file);
  EXPECT_NE(second, first);
  files.write("s.xml", scene_test::scene(scene_test::mesh()) + "\n");
  EXPECT_NE(fingerprintOfScene(file), second);
}

/// Two filters of a small scene: half of it is covered by a triangle, whose normal is (0, 0, 1).
class ChartTruth : public testing::Test {
 protected:
  ChartTruth() {
    files_.write("t.obj", "v -1 -1 0\nv 1 -1 0\nv -1 1 0\nf 1 2 3\n");
    scene_ =
        loadScene(
            files_.write("s.xml",
                         scene_test::scene(
                             "<camera type=\"perspective\"><integer name=\"width\" value=\"12\"/>"
                             "<integer name=\"height\" value=\"10\"/><transform name=\"toWorld\">"
                             "<lookat origin=\"0,0,4\" target=\"0,0,0\" up=\"0,1,0\"/></transform>"
                             "</camera>" +
                             scene_test::mesh())))
            .scene;
    filters_ = {*filterFromName("box"), *filterFromName("gaussian")};
  }
  std::vector<Truth> make(const std::function<bool()>& stop = {}, std::uint32_t samples = 60) {
    TruthOptions options;
    options.samples = samples;  // 8 x 8
    options.stop = stop;
    options.progress = [&](double share) { shares_.push_back(share); };
    return truthOf(scene_, filters_, options, kept_, "key");
  }

  Folder folder_;
  scene_test::Files files_;
  Kept kept_{folder_.file("kept")};
  Scene scene_;
  std::vector<Filter> filters_;
  std::vector<double> shares_;
};

TEST_F(ChartTruth, IsNearTheConvergedPictureByEachFilter) {
  const auto truths = make();
  ASSERT_EQ(truths.size(), 2U);
  for (std::size_t f = 0; f < 2; ++f) {
    Scene scene = scene_;
    scene.filter = filters_[f];
    scene.sampler.sampleCount = 4096;
    const Image image = Reference(scene).render().image;
    const double off = errorsOf(truths[f].image, image).rmse;
    EXPECT_GT(truths[f].band, 0.0);
    // Independent samples err by 0.5 / sqrt(4096) at an edge, a third of the film's pixels.
    EXPECT_LT(off, 0.008) << f;
    EXPECT_LT(truths[f].band, 0.008) << f;
    EXPECT_GT(off, 0.0);
  }
}

TEST_F(ChartTruth, TheBandIsItsErrorWithinTheNoiseOfAnEstimate) {
  const Image better = make({}, 4096).at(0).image;
  const auto truth = make().at(0);
  const double off = errorsOf(truth.image, better).rmse;
  // Some 15 edge pixels tell an RMSE to a fifth; three times that.
  EXPECT_GT(truth.band, off * 0.4);
  EXPECT_LT(truth.band, off * 2.5);
}

TEST_F(ChartTruth, GoesOnWhereItWasStopped) {
  int left = 37;
  EXPECT_TRUE(make([&] { return left-- == 0; }).empty());
  const std::size_t before = shares_.size();
  EXPECT_EQ(before, 37U);
  const auto resumed = make();
  EXPECT_EQ(shares_.size(), 128U);  // none is done twice
  std::filesystem::remove_all(folder_.file("kept"));
  std::filesystem::create_directory(folder_.file("kept"));
  const auto whole = make();
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_EQ(resumed[f].image.pixels, whole[f].image.pixels);
    EXPECT_EQ(resumed[f].band, whole[f].band);
  }
}

TEST_F(ChartTruth, IsMadeOnce) {
  const auto first = make();
  shares_.clear();
  EXPECT_EQ(make().at(0).image.pixels, first[0].image.pixels);
  EXPECT_TRUE(shares_.empty());
}

}  // namespace
}  // namespace laver::chart
