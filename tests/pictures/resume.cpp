// A resumed render has the same bits as one that was never stopped.
#include "commands/resume.h"

#include "core/error.h"
#include "image/io.h"
#include "pictures/command_line.h"
#include "pictures/harness.h"

namespace laver::test {
namespace {

using Keep = FilmState::Keep;

Scene sceneOf(const SamplerRow* kind, std::uint32_t samples) {
  Scene scene = smallScene("cornell-two-lights.xml", 64, samples);
  scene.sampler.row = kind;
  return scene;
}

/// Bands of some rows, few samples per pass.
VulkanOptions inPieces(const char* traversal) {
  VulkanOptions vulkan = onTestDevice();
  vulkan.traversal = traversal;
  vulkan.samplesInFlight = 5120;
  return vulkan;
}

/// The state after writing it to a file and reading it back.
FilmState throughAFile(const FilmState& state, const std::string& file) {
  writeState(file, state, 1);
  return readState(file);
}

class Resume : public CommandLine {
 protected:
  /// Renders `passes` passes, and then the rest from the kept sums.
  Image inTwoRuns(Renderer& renderer, const Scene& first, const Scene& then, int passes,
                  Keep keep) {
    FilmState state(keep);
    Stats stats;
    renderer.render(first, StopAfter(passes).options(), state, stats);
    FilmState read = state.empty() ? FilmState(Keep::Always) : throughAFile(state, path("s.exr"));
    return renderer.render(then, {}, read, stats).image;
  }
};

TEST_F(Resume, AfterAnInterruptionAnywhereByLaneAndPackets) {
  for (const auto& [traversal, kind] :
       {std::pair("lane", &samplers::sobol), std::pair("packet64", &samplers::sobol),
        std::pair("packet32", &samplers::stratified),
        std::pair("packet64", &samplers::independent)}) {
    Renderer renderer(inPieces(traversal));
    const Scene scene = sceneOf(kind, 16);
    Stats stats;
    const Image whole = renderer.render(scene, {}, stats).image;
    ASSERT_GT(stats.bands, 2U);
    for (const int passes : {0, 3, 4, 6, static_cast<int>(stats.passes) - 1})
      EXPECT_EQ(differingFloats(whole, inTwoRuns(renderer, scene, scene, passes, Keep::WhenEnded)),
                0U)
          << traversal << ' ' << kind->name << " after " << passes << " passes";
    EXPECT_EQ(differingFloats(whole, inTwoRuns(renderer, scene, scene, 6, Keep::Always)), 0U);
  }
}

TEST_F(Resume, SobolGoesOnBeyondTheCountItWasBegunWith) {
  for (const auto& [traversal, few] : {std::pair("lane", 16U), std::pair("packet64", 1U),
                                       std::pair("packet32", 10U), std::pair("packet64", 16U)}) {
    Renderer renderer(inPieces(traversal));
    const Scene many = sceneOf(&samplers::sobol, 64);
    Stats stats;
    const Image whole = renderer.render(many, {}, stats).image;
    for (const int passes : {3, 1000})
      EXPECT_EQ(differingFloats(whole, inTwoRuns(renderer, sceneOf(&samplers::sobol, few), many,
                                                 passes, Keep::Always)),
                0U)
          << traversal << " from " << few << " after " << passes << " passes";
  }
}

TEST_F(Resume, IsTheSameInOneBand) {
  Renderer pieces(inPieces("packet")), one(onTestDevice());
  const Scene scene = sceneOf(&samplers::sobol, 24);
  Stats stats;
  const Image whole = one.render(scene, {}, stats).image;
  FilmState state(Keep::Always);
  pieces.render(sceneOf(&samplers::sobol, 16), StopAfter(7).options(), state, stats);
  EXPECT_EQ(differingFloats(whole, one.render(scene, {}, state, stats).image), 0U);
}

TEST_F(Resume, AStoppedSecondRunShowsTheFirstWhereItIsMissing) {
  // 16 samples in every row, then 64 in some: nothing is black.
  Renderer renderer(inPieces("packet"));
  FilmState state(Keep::Always);
  Stats stats;
  const Image before = renderer.render(sceneOf(&samplers::sobol, 16), {}, state, stats).image;
  const auto [after, reached, dropped] =
      renderer.render(sceneOf(&samplers::sobol, 64), StopAfter(13).options(), state, stats);
  EXPECT_EQ(reached.rows, 64);
  EXPECT_GT(reached.wholeRows, 0);
  EXPECT_EQ(reached.samples, 16U);
  const std::size_t last = after.pixels.size() - std::size_t{3} * 64;
  EXPECT_TRUE(std::equal(after.pixels.begin() + static_cast<std::ptrdiff_t>(last),
                         after.pixels.end(),
                         before.pixels.begin() + static_cast<std::ptrdiff_t>(last)));
}

std::string arguments(const std::string& more, const char* size = "40x40") {
  return (scenesFolder() / "cornell-two-lights.xml").string() +
         " --device $device --quiet -o a.exr --size " + size + ' ' + more;
}

TEST_F(Resume, OnTheCommandLine) {
  EXPECT_EQ(laver(arguments("--sampler sobol --spp 16 --resume")).code, 0);
  EXPECT_EQ(files(), (std::set<std::string>{"a.exr", "a.png", "a.state.exr"}));
  EXPECT_EQ(laver(arguments("--sampler sobol --spp 64 --resume --traversal lane")).code, 0);
  const Image went = readExr(path("a.exr"));
  EXPECT_EQ(laver(arguments("--sampler sobol --spp 64")).code, 0);
  EXPECT_EQ(differingFloats(went, readExr(path("a.exr"))), 0U);

  // Nothing is left to render: the same picture again.
  EXPECT_EQ(laver(arguments("--sampler sobol --spp 64 --resume --stats=s.json")).code, 0);
  EXPECT_NE(contents(path("s.json")).find("\"passes\": 0"), std::string::npos);
  EXPECT_EQ(differingFloats(went, readExr(path("a.exr"))), 0U);
}

TEST_F(Resume, InvalidFilesAreRefusedInOneLine) {
  const auto refused = [&](const std::string& more, const std::string& reason,
                           const char* size = "40x40") {
    const Outcome run = laver(arguments(more + " --resume", size));
    EXPECT_EQ(run.code, 2) << more;
    EXPECT_EQ(run.err, "laver: cannot resume from \"a.state.exr\": " + reason + "\n");
  };
  ASSERT_EQ(laver(arguments("--sampler sobol --spp 8 --resume")).code, 0);
  refused("--sampler sobol --spp 4", "it holds 8 samples per pixel, 4 are requested");
  refused("--sampler sobol --spp 16 --seed 2", "seed was 0, now it is 2");
  refused("--sampler sobol --spp 16 --integrator depth",
          "integrator was direct_whitted, now it is depth");
  refused("--sampler sobol --spp 16", "film was 40x40, now it is 40x41", "40x41");
  refused("--sampler sobol --spp 16 --crop 0,0,9,9", "crop was 0,0,40,40, now it is 0,0,9,9");
  refused("--sampler sobol --spp 16 --nori-compat",
          "filterWeights was exact, now it is Nori's table");
  refused("--sampler stratified --spp 16", "sampler was sobol, now it is stratified");
  const Outcome reference = laver(arguments("--reference --resume"));
  EXPECT_EQ(reference.code, 2);
  EXPECT_EQ(lines(reference.err), 1);

  // Damages a byte in the middle, which lies in a compressed or a stored chunk.
  std::string bytes = contents(path("a.state.exr"));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  write("a.state.exr", bytes);
  const Outcome damaged = laver(arguments("--sampler sobol --spp 16 --resume"));
  EXPECT_EQ(damaged.code, 2);
  EXPECT_EQ(lines(damaged.err), 1);
  EXPECT_EQ(damaged.err.find("laver: cannot re"), 0U) << damaged.err;
  write("a.state.exr", bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(laver(arguments("--sampler sobol --spp 16 --resume")).code, 2);
  fs::copy_file(path("a.exr"), path("a.state.exr"), fs::copy_options::overwrite_existing);
  refused("--sampler sobol --spp 16", "it is damaged, or not a file of sums");
}

TEST_F(Resume, AnotherSceneOrCountIsRefused) {
  const Scene scene = sceneOf(&samplers::stratified, 16);
  Renderer renderer(inPieces("packet"));
  Stats stats;
  const auto reasonOf = [&](const Scene& first, const Scene& then, Keep keep) {
    FilmState state(keep);
    renderer.render(first, StopAfter(6).options(), state, stats);
    try {
      renderer.render(then, {}, state, stats);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::Usage);
      const std::string text = error.what();
      return text.substr(text.find(": ") + 2);
    }
    return std::string();
  };
  EXPECT_EQ(
      reasonOf(scene, sceneOf(&samplers::stratified, 64), Keep::Always),
      "started with 16 samples per pixel, 64 are requested: this sampler's samples depend on their "
      "count, those of sobol do not");
  EXPECT_EQ(reasonOf(sceneOf(&samplers::sobol, 16), sceneOf(&samplers::sobol, 64), Keep::WhenEnded)
                .substr(0, 32),
            "it was started without --resume:");
  const char* const changed = "the scene or a file that it names has changed";
  Scene other = scene;
  other.meshes[0].positions[0].x += 1e-6;
  EXPECT_EQ(reasonOf(scene, other, Keep::Always), changed);
  other = scene;
  other.lights[1].radiance.x *= 1.0001;
  EXPECT_EQ(reasonOf(scene, other, Keep::Always), changed);
  other = scene;
  other.meshes[0].bsdf.set("albedo", other.meshes[0].bsdf.color("albedo") * 0.999);
  EXPECT_EQ(reasonOf(scene, other, Keep::Always), changed);
  other = scene;
  other.camera.fov += 1e-5;
  EXPECT_EQ(reasonOf(scene, other, Keep::Always), changed);
  other = scene;
  other.filter.stddev = 0.6;
  EXPECT_EQ(reasonOf(scene, other, Keep::Always), changed);
  EXPECT_EQ(reasonOf(scene, scene, Keep::Always), "");

  Scene withSphere = scene;
  withSphere.meshes.emplace_back().sphere = Sphere{glm::dvec3(0.0, 0.4, 0.0), 0.2};
  EXPECT_EQ(reasonOf(scene, withSphere, Keep::Always), changed);
  other = withSphere;
  other.meshes.back().sphere->centre.y += 1e-6;
  EXPECT_EQ(reasonOf(withSphere, other, Keep::Always), changed);
  other = withSphere;
  other.meshes.back().sphere->radius += 1e-6;
  EXPECT_EQ(reasonOf(withSphere, other, Keep::Always), changed);
  EXPECT_EQ(reasonOf(withSphere, withSphere, Keep::Always), "");
}

}  // namespace
}  // namespace laver::test
