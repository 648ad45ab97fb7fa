// Random scenes by the device and by the reference: whatever differs is explained.
#include <gtest/gtest.h>

#include <cstdlib>

#include "random/shrink.h"
#include "random/verdict.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

/// What is refused is counted, and may not be much.
void expectPassed(std::uint64_t from, std::uint64_t to, std::uint64_t kinds) {
  Court court;
  std::uint64_t refused = 0, count = 0;
  for (const std::uint64_t seed : seedsByKind(from, to)) {
    if (kinds != kKinds && seed / kBlock % kKinds != kinds) continue;
    const RandomScene random = randomScene(seed);
    const Verdict verdict = court.judge(random);
    refused += verdict.result == Verdict::Result::Refused ? 1 : 0;
    ++count;
    EXPECT_FALSE(verdict.failed()) << "seed " << seed << ": " << verdict.why << "\n"
                                   << random.traits;
  }
  testing::Test::RecordProperty("refused", static_cast<int>(refused));
  EXPECT_LE(refused, count / 20);
}

TEST(RandomScenesWritten, AreReadAsTheyWere) {
  // One of each kind.
  for (std::uint64_t seed = 0; seed < kBlock * kKinds; seed += kBlock) {
    const Scene scene = randomScene(seed).scene;
    const TemporaryFolder folder;
    writeScene(scene, folder.path().string());
    const Scene read = loadScene((folder.path() / "scene.xml").string()).scene;
    EXPECT_EQ(read.integrator.row, scene.integrator.row);
    EXPECT_EQ(read.camera.toWorld, scene.camera.toWorld);
    EXPECT_EQ(read.lights.size(), scene.lights.size());
    EXPECT_EQ(read.filter.radius, scene.filter.radius);
    EXPECT_EQ(read.environment.has_value(), scene.environment.has_value());
    ASSERT_EQ(read.meshes.size(), scene.meshes.size()) << seed;
    for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
      EXPECT_EQ(read.meshes[i].primitives(), scene.meshes[i].primitives()) << seed << ' ' << i;
      EXPECT_EQ(read.meshes[i].bsdf.row, scene.meshes[i].bsdf.row) << seed << ' ' << i;
    }
  }
}

class RandomScenes : public testing::TestWithParam<std::uint64_t> {};

/// Nothing differs but what rounding explains; no crash, no value that is not finite. Most of the
/// time is the driver's, which compiles some kernel for each scene: for all hundreds but two,
/// lavapipe does so without its optimiser, in half of the time.
TEST_P(RandomScenes, AreThoseOfTheReference) {
  if (GetParam() >= 2) setenv("GALLIVM_PERF", "nopt", 1);
  expectPassed(100 * GetParam(), 100 * (GetParam() + 1), kKinds);
}

INSTANTIATE_TEST_SUITE_P(Hundred, RandomScenes, testing::Range<std::uint64_t>(0, 10));

/// Those of one kind among 1e5, since a process that has many kernels grows.
class FullRandomScenes : public testing::TestWithParam<std::uint64_t> {};

TEST_P(FullRandomScenes, AreThoseOfTheReference) { expectPassed(0, 100000, GetParam()); }

INSTANTIATE_TEST_SUITE_P(FullKind, FullRandomScenes, testing::Range<std::uint64_t>(0, kKinds));

}  // namespace
}  // namespace laver::test
