// Parts of a picture, merged, have the bits of the whole.
#include <fmt/format.h>

#include "commands/parts.h"
#include "commands/resume.h"
#include "image/io.h"
#include "pictures/command_line.h"
#include "pictures/harness.h"

namespace laver::test {
namespace {

class Shards : public CommandLine {
 protected:
  Outcome render(const std::string& more, const std::string& output) {
    return laver((scenesFolder() / "cornell-two-lights.xml").string() + " --device $device -q -o " +
                 output + ' ' + more);
  }
  /// Renders part `index` as pINDEX.exr.
  void part(int index, int count, const std::string& more) {
    const Outcome run =
        render(fmt::format("--shard {}/{} {}", index, count, more), fmt::format("p{}.exr", index));
    ASSERT_EQ(run.code, 0) << run.err;
  }
  Outcome merge(const std::string& parts) { return laver("merge " + parts + " -o merged.exr"); }

  /// Expects the same picture, PNG and place on the film from parts and in one go.
  void expectSame(const std::string& options, int count) {
    std::string parts;
    for (int i = count - 1; i >= 0; --i) {
      part(i, count, options);
      parts += fmt::format(" p{}.exr", i);
    }
    const Outcome merged = merge(parts);
    ASSERT_EQ(merged.code, 0) << merged.err;
    ASSERT_EQ(render(options, "whole.exr").code, 0);
    const Image a = readExr(path("merged.exr")), b = readExr(path("whole.exr"));
    EXPECT_EQ(a.channels, b.channels) << options;
    EXPECT_EQ(a.window, b.window) << options;
    EXPECT_EQ(differingFloats(a, b), 0U) << options << ", " << count << " parts";
    EXPECT_EQ(contents(path("merged.png")), contents(path("whole.png")));
  }

  /// Expects that merging is refused with one line, and writes nothing.
  void expectRefused(const std::string& parts, const std::string& reason) {
    const Outcome run = merge(parts);
    EXPECT_EQ(run.code, 2) << parts;
    EXPECT_EQ(run.err, "laver: cannot merge" + reason + "\n");
    EXPECT_FALSE(fs::exists(path("merged.exr")));
    EXPECT_FALSE(fs::exists(path("merged.png")));
  }
};

// Two strips for each of three parts.
const std::string kTall = "--size 16x250 --spp 4 ";

TEST_F(Shards, MergeToTheBitsOfTheWhole) {
  for (const int count : {1, 3, 8}) expectSame("--size 64x48 --spp 2", count);
  expectSame(kTall, 3);
  EXPECT_EQ(readPart(path("p1.exr")).rows.size(), 2U);
}

TEST_F(Shards, HaveTheirRowsOnly) {
  part(2, 8, "--size 64x48 --spp 2");
  EXPECT_EQ(readExr(path("p2.exr")).height, 6);
  EXPECT_EQ(readExrTexts(path("p2.exr")).at("shard"), "2/8");
  EXPECT_EQ(readExrTexts(path("p2.exr")).at("shard.rows"), "12-17");
  EXPECT_EQ(files(), std::set<std::string>{"p2.exr"});
}

TEST_F(Shards, MergeLayers) {
  expectSame(kTall + "--layers normals,depth,albedo,position,id,samples,variance", 3);
  expectSame("--size 64x48 --spp 2 --integrator direct_whitted,ao --layers depth", 3);
}

TEST_F(Shards, MergeAdaptiveSampling) {
  expectSame("--size 32x250 --spp 32 --error 0.02 --layers normals", 3);
  expectSame("--size 64x48 --spp 32 --error 0.02", 8);
}

TEST_F(Shards, MergeACrop) {
  expectSame(kTall + "--crop 3,5,13,240 --layers depth,variance", 3);
  expectSame("--size 32x48 --spp 32 --error 0.02 --crop 3,5,30,44", 3);
}

TEST_F(Shards, MergeTheReference) {
  // 100 samples per pixel in several batches, on which variances depend.
  expectSame("--size 16x250 --spp 100 --reference --integrator normals --layers depth,variance", 3);
  expectSame("--size 64x48 --spp 2 --reference --layers samples,id", 8);
}

TEST_F(Shards, VariancesHaveThePassesOfTheWhole) {
  VulkanOptions vulkan = onTestDevice();
  // 16 of 64 samples per pass, of which a third of the rows would leave room for 32.
  vulkan.samplesInFlight = 41000;
  Renderer renderer(vulkan);
  const Scene scene = smallScene("cornell-two-lights.xml", 48, 64);
  RenderOptions options;
  options.layers = {&layers::variance};
  Stats stats;
  const Image whole = renderer.render(scene, options, stats).image;
  ASSERT_EQ(stats.samplesPerPass, 16U);
  options.shard = Shard{1, 3};
  const Image part = renderer.render(scene, options, stats).image;
  ASSERT_EQ(part.height, 16);
  EXPECT_TRUE(
      std::equal(part.pixels.begin(), part.pixels.end(), whole.pixels.begin() + 16 * 48 * 3 * 2));
}

TEST_F(Shards, ThatAreNoneAreUsageErrors) {
  for (const char* shard : {"8/8", "3", "-1/4", "1/0", "a/b", "1/2/3"}) {
    const Outcome run = render(fmt::format("--size 8x8 --shard {}", shard), "a.exr");
    EXPECT_EQ(run.code, 2) << shard;
    EXPECT_EQ(lines(run.err), 1) << run.err;
  }
  const Outcome run = render("--size 64x48 --shard 0/49", "a.exr");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.err, "laver: --shard 0/49: a picture of 48 rows has that many parts at most\n");
  EXPECT_EQ(files(), std::set<std::string>{});
}

TEST_F(Shards, OfOtherRendersAreRefused) {
  const std::string options = "--size 16x12 --spp 2 ";
  part(0, 2, options);
  const auto other = [&](const std::string& changed, const std::string& reason, int count = 2) {
    part(1, count, changed);
    expectRefused("p0.exr p1.exr", ": " + reason);
  };
  const std::string of = " of \"p1.exr\" is ";
  other(options + "--seed 7", "seed" + of + "7, of \"p0.exr\" 0");
  other("--size 16x12 --spp 3", "sampleCount" + of + "3, of \"p0.exr\" 2");
  other("--size 16x13 --spp 2", "crop" + of + "0,0,16,13, of \"p0.exr\" 0,0,16,12");
  other(options + "--layers depth", "channels" + of + "B G R Z, of \"p0.exr\" B G R");
  other(options + "--integrator ao", "integrator" + of + "ao, of \"p0.exr\" direct_whitted");
  other(options + "--reference", "device" + of + "reference, of \"p0.exr\" " +
                                     readPart(path("p0.exr")).settings.at("device"));
  other(options + "--filter tent", "the scenes of \"p1.exr\" and \"p0.exr\" differ");
  other("--size 16x12 --spp 8 --error 0.1", "channels" + of + "B G R samples, of \"p0.exr\" B G R");
  other(options, "\"p1.exr\" is part 1/3, \"p0.exr\" is part 0/2", 3);
}

TEST_F(Shards, OfAnotherVersionOrDriverAreRefused) {
  for (int i = 0; i < 2; ++i) part(i, 2, "--size 16x12");
  Metadata metadata = readExrMetadata(path("p1.exr"));
  const Image image = readExr(path("p1.exr"));
  for (const char* name : {"laverVersion", "driver"}) {
    Metadata changed = metadata;
    changed["shard.settings." + std::string(name)] = "older";
    writeExr(path("p1.exr"), image, changed);
    const Outcome run = merge("p0.exr p1.exr");
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.err.find(fmt::format("laver: cannot merge: {} of \"p1.exr\" is older,", name)),
              0U)
        << run.err;
  }
}

TEST_F(Shards, ThatAreMissingOrTwiceAreNamed) {
  for (int i = 0; i < 4; ++i) part(i, 4, "--size 16x12");
  expectRefused("p0.exr p2.exr p3.exr", ": part 1/4 is missing");
  expectRefused("p3.exr", ": parts 0/4, 1/4, 2/4 are missing");
  expectRefused("p0.exr p2.exr p2.exr p3.exr",
                ": part 2/4 is there twice, \"p2.exr\" and \"p2.exr\"");
  EXPECT_EQ(laver("merge p0.exr p1.exr p2.exr p3.exr -o p1.exr").code, 2);
  EXPECT_EQ(laver("merge p0.exr p1.exr p2.exr p3.exr").code, 2);
  EXPECT_EQ(laver("merge -o a.exr").code, 2);
  EXPECT_EQ(merge("p0.exr none.exr").code, 2);
  EXPECT_EQ(merge("p0.exr p1.exr p2.exr p3.exr").code, 0);
  const Outcome whole = laver("merge merged.exr -o a.exr");
  EXPECT_EQ(whole.code, 2);
  EXPECT_EQ(whole.err, "laver: \"merged.exr\" is no part of a picture: --shard writes them\n");
}

TEST_F(Shards, ThatAreDamagedAreRefused) {
  for (int i = 0; i < 2; ++i) part(i, 2, "--size 16x12");
  Image image = readExr(path("p1.exr"));
  Metadata metadata = readExrMetadata(path("p1.exr"));
  image.at(3, 2, 1) += 1.0F;
  writeExr(path("p1.exr"), image, metadata);
  expectRefused("p0.exr p1.exr", " \"p1.exr\": it is damaged");
  metadata["shard.rows"] = "0-5";
  image.at(3, 2, 1) -= 1.0F;
  writeExr(path("p1.exr"), image, metadata);
  expectRefused("p0.exr p1.exr", " \"p1.exr\": it is damaged");
}

TEST_F(Shards, ThatWereInterruptedAreRefusedAndGoOn) {
  const std::string options = "--size 16x250 --spp 16 --shard 1/3";
  for (const int i : {0, 2}) part(i, 3, "--size 16x250 --spp 16");
  RenderCommand command;
  command.scene = (scenesFolder() / "cornell-two-lights.xml").string();
  command.overrides.size = glm::ivec2(16, 250);
  command.overrides.sampleCount = 16;
  const Scene scene = loadScene(command.scene, command.overrides).scene;
  VulkanOptions vulkan = onTestDevice();
  vulkan.samplesInFlight = 5120;
  Renderer renderer(vulkan);
  for (const int passes : {2, 5}) {
    StopAfter stop(passes);
    command.options = stop.options();
    command.options.shard = Shard{1, 3};
    FilmState state(FilmState::Keep::WhenEnded);
    Stats stats;
    const Rendered rendered = renderer.render(scene, command.options, state, stats);
    ASSERT_FALSE(rendered.whole());
    writePart(path("p1.partial.exr"), command, scene, rendered, state.settings, {});
    writeState(path("p1.state.exr"), state, 1);
    const Outcome refused = merge("p0.exr p1.partial.exr p2.exr");
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(refused.err,
              fmt::format("laver: cannot merge: part 1/3, \"p1.partial.exr\", was interrupted: {} "
                          "of {} rows are finished\n",
                          rendered.reached.wholeRows, rendered.image.height));

    const Outcome resumed = render(options + " --resume", "p1.exr");
    ASSERT_EQ(resumed.code, 0) << resumed.err;
    ASSERT_EQ(merge("p0.exr p1.exr p2.exr").code, 0);
    ASSERT_EQ(render("--size 16x250 --spp 16", "whole.exr").code, 0);
    EXPECT_EQ(differingFloats(readExr(path("merged.exr")), readExr(path("whole.exr"))), 0U);
  }
  // Its sums are of no other part.
  ASSERT_EQ(render(options + " --resume --sampler sobol", "p1.exr").code, 0);
  const Outcome other =
      render("--size 16x250 --spp 16 --shard 2/3 --resume --sampler sobol", "p1.exr");
  EXPECT_EQ(other.code, 2);
  EXPECT_EQ(other.err,
            "laver: cannot resume from \"p1.state.exr\": shard was 1/3, now it is 2/3\n");
}

TEST_F(Shards, LieBesideTheSceneByDefault) {
  write("test.xml", kFirstScene);
  EXPECT_EQ(laver("test.xml --device $device -q --size 8x8 --shard 1/2").code, 0);
  EXPECT_EQ(files(), (std::set<std::string>{"test.1-of-2.exr", "test.xml"}));
}

}  // namespace
}  // namespace laver::test
