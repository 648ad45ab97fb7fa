// A render in progress as an observer sees it, in the process and over a socket.
#include <future>
#include <limits>

#include "image/io.h"
#include "pictures/command_line.h"
#include "pictures/harness.h"
#include "reference/reference.h"
#include "unit/viewer.h"

namespace laver::test {
namespace {

/// Keeps the rows that it receives.
struct Seen : Observer {
  Image picture;
  int calls = 0;

  void rowsChanged(const Image& now, int first, int end) override {
    if (calls++ == 0) picture = rgbImage(now.width, now.height);
    ASSERT_TRUE(0 <= first && first < end && end <= now.height);
    for (int y = first; y < end; ++y)
      for (int x = 0; x < now.width; ++x)
        for (std::size_t c = 0; c < 3; ++c) picture.at(x, y, c) = now.at(x, y, c);
  }
  double timeShare() const override { return std::numeric_limits<double>::infinity(); }

  RenderOptions options() { return {.observers = {this}}; }
};

TEST(Watcher, SeesEveryPassAndFinallyThePicture) {
  const Scene scene = smallScene("cornell-two-lights.xml", 64, 32);
  VulkanOptions vulkan = onTestDevice();
  vulkan.samplesInFlight = 10240;  // bands of some rows, eight samples per pass
  Stats stats;
  Seen seen;
  const Image image = Renderer(vulkan).render(scene, seen.options(), stats).image;
  EXPECT_EQ(stats.passes, 4 * stats.bands);
  EXPECT_EQ(seen.calls, static_cast<int>(stats.passes));
  EXPECT_EQ(differingFloats(seen.picture, image), 0U);
  EXPECT_EQ(differingFloats(render(scene), image), 0U);
}

TEST(Watcher, SeesTheFirstPictureOnlyAndACropFromItsTop) {
  const Scene scene = smallScene("cornell-two-lights.xml", 64, 4);
  Seen seen;
  RenderOptions options = seen.options();
  options.more = {{&integrators::depth}};
  options.layers = {&layers::albedo, &layers::depth};
  options.crop = Crop{10, 20, 40, 50};
  Stats stats;
  Renderer(onTestDevice()).render(scene, options, stats);
  EXPECT_EQ(seen.calls, 1);
  RenderOptions cropOnly;
  cropOnly.crop = options.crop;
  EXPECT_EQ(differingFloats(seen.picture, render(scene, onTestDevice(), cropOnly)), 0U);
}

TEST(Watcher, SeesAReferenceRender) {
  // The reference takes 2^18 samples at once: 64 per pixel of 64 x 64.
  const Scene scene = smallScene("cornell-two-lights.xml", 64, 192);
  Seen seen;
  RenderOptions options = seen.options();
  options.layers = {&layers::normals};
  const Image image = Reference(scene).render(options).image;
  EXPECT_EQ(seen.calls, 3);
  EXPECT_EQ(differingFloats(seen.picture, Reference(scene).render().image), 0U);
}

TEST(Watcher, SeesTheRestOfAStoppedRender) {
  const Scene scene = smallScene("cornell-two-lights.xml", 64, 32);
  VulkanOptions vulkan = onTestDevice();
  vulkan.samplesInFlight = 5120;
  Seen seen;
  RenderOptions options = seen.options();
  StopAfter stop(6);
  options.observers.push_back(&stop);
  Stats stats;
  const Image image = Renderer(vulkan).render(scene, options, stats).image;
  EXPECT_EQ(differingFloats(seen.picture, image), 0U);
}

const char* const kScene =
    "<scene><integrator type=\"depth\"/><camera type=\"perspective\">"
    "<integer name=\"width\" value=\"200\"/><integer name=\"height\" value=\"150\"/></camera>"
    "<sampler type=\"independent\"><integer name=\"sampleCount\" value=\"8\"/></sampler>"
    "<mesh type=\"obj\"><string name=\"filename\" value=\"a.obj\"/></mesh></scene>";

TEST_F(CommandLine, AViewerGetsThePictureBitForBit) {
  write("a.obj", "v -1 -1 2\nv 1 -1 3\nv 0 1 5\nf 1 2 3\n");
  write("a.xml", kScene);
  for (const std::string how :
       {"--device $device", "--reference", "--device $device --layers normals,id"}) {
    const Listener listener;
    auto viewer = std::async(std::launch::async, [&] { return Viewer(listener.accept()); });
    const Outcome run =
        laver("a.xml -q -o b.exr --display-server 127.0.0.1:" + listener.port() + " " + how);
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    const Viewer seen = viewer.get();
    const Image image = readExr(path("b.exr"));
    EXPECT_EQ(seen.name, "b.exr");
    ASSERT_EQ(seen.picture.width, 200);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto channel = static_cast<std::size_t>(
          std::find(image.channels.begin(), image.channels.end(), seen.picture.channels[c]) -
          image.channels.begin());
      ASSERT_LT(channel, image.channels.size());
      for (int y = 0; y < 150; ++y)
        for (int x = 0; x < 200; ++x)
          ASSERT_EQ(seen.picture.at(x, y, c), image.at(x, y, channel)) << how;
    }
  }
}

TEST_F(CommandLine, AMissingViewerIsAWarning) {
  write("a.obj", "v -1 -1 2\nv 1 -1 3\nv 0 1 5\nf 1 2 3\n");
  write("a.xml", kScene);
  const std::string port = Listener().port();
  const Outcome run = laver("a.xml -q --reference --display-server localhost:" + port);
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(lines(run.err), 1) << run.err;
  EXPECT_NE(run.err.find("warning: display server localhost port " + port), std::string::npos);
  EXPECT_TRUE(fs::exists(path("a.exr")));
  EXPECT_EQ(laver("a.xml --display-server nonsense:x").code, 2);
}

}  // namespace
}  // namespace laver::test
