// Ctrl-C and SIGTERM, as a user or a job control sends them.
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <fmt/format.h>
#include <pty.h>
#include <sys/stat.h>

#include <fstream>

#include "image/io.h"
#include "pictures/child.h"
#include "pictures/command_line.h"
#include "pictures/harness.h"
#include "reference/reference.h"

namespace laver::test {
namespace {

/// A render of 2^20 samples per pixel, which takes hours.
std::vector<std::string> longRender() {
  return {(scenesFolder() / "cornell-two-lights.xml").string(),
          "--size",
          "64x48",
          "--spp",
          "1048576",
          "-o",
          "a.exr"};
}

int attribute(const std::string& file, const char* name) {
  const Imf::InputFile input(file.c_str());
  const auto* value = input.header().findTypedAttribute<Imf::IntAttribute>(name);
  return value == nullptr ? -1 : value->value();
}

/// Reads the terminal until `part` appears, or to the end if `part` is empty.
std::string readTerminal(int terminal, const std::string& part) {
  std::string text;
  char buffer[256];
  while (part.empty() || text.find(part) == std::string::npos) {
    const ssize_t count = ::read(terminal, buffer, sizeof buffer);
    if (count <= 0) break;  // EIO: the other end is closed
    text.append(buffer, static_cast<std::size_t>(count));
  }
  return text;
}

/// Whether a signal set of /proc/PID/status contains SIGINT.
bool hasSigint(const Child& child, const std::string& set) {
  std::ifstream status("/proc/" + std::to_string(child.process()) + "/status");
  for (std::string word; status >> word;)
    if (word == set && status >> word)
      return (std::stoull(word, nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  return false;
}

class Interruption : public CommandLine {
 protected:
  /// Interrupts a render once it shows progress, that is, after its first pass.
  void endsEarly(const std::vector<std::string>& arguments, int signal, int code) {
    write("a.exr", "precious");
    write("a.png", "precious too");
    int ends[2] = {-1, -1};
    ASSERT_EQ(::openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr), 0);
    const Descriptor terminal(ends[0]);
    Descriptor other(ends[1]);
    Child child(folder_, arguments, {}, other.get());
    other.close();
    readTerminal(terminal.get(), "%");
    child.send(signal);
    const std::string err = readTerminal(terminal.get(), "");
    EXPECT_EQ(child.wait(), code) << err;

    EXPECT_EQ(contents(path("a.exr")), "precious");
    EXPECT_EQ(contents(path("a.png")), "precious too");
    const bool reference = arguments.back() == "--reference";
    std::set<std::string> left{"a.exr", "a.png", "a.partial.exr", "a.partial.png"};
    if (!reference) left.insert("a.state.exr");
    EXPECT_EQ(files(), left);
    const std::string partial = path("a.partial.exr");
    const int samples = attribute(partial, "samplesPerPixel");
    EXPECT_GT(samples, 0);
    EXPECT_LT(samples, 1 << 20);
    EXPECT_EQ(attribute(partial, "samplesPerPixelWanted"), 1 << 20);
    EXPECT_EQ(attribute(partial, "rowsReached"), 48);
    EXPECT_EQ(attribute(partial, "rowsComplete"), 0);
    EXPECT_NE(
        err.find(fmt::format("laver: interrupted with {} of 1048576 samples per pixel in 48 of "
                             "48 rows; see \"a.partial.exr\"{}\r\n",
                             samples, reference ? "" : "; --resume goes on from \"a.state.exr\"")),
        std::string::npos)
        << err;
    const Image image = readExr(partial);
    for (const float v : image.pixels) ASSERT_TRUE(std::isfinite(v));
    EXPECT_GT(image.at(32, 24, 0), 0.0F);
  }

  /// Starts a render whose scene is a pipe, calls act(child) while it waits for the scene, and then
  /// writes the scene. Returns the exit code.
  template <class Act>
  int whileLoading(void (*interrupt)(int), Act act) {
    EXPECT_EQ(::mkfifo(path("scene.xml").c_str(), 0600), 0);
    Child child(folder_, {"scene.xml", "--reference", "--size", "8x8", "--quiet", "-o", "a.exr"},
                {}, {}, interrupt);
    int end = -1;
    while (end < 0 && !child.ended()) {
      end = ::open(path("scene.xml").c_str(), O_WRONLY | O_NONBLOCK);
      if (end < 0) ::usleep(1000);
    }
    Descriptor pipe(end);
    act(child);
    const std::string text = kFirstScene;
    EXPECT_EQ(::write(pipe.get(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
    pipe.close();
    return child.wait();
  }
};

TEST_F(Interruption, CtrlCWritesThePartialPictureUnderAnotherName) {
  auto arguments = longRender();
  arguments.insert(arguments.end(), {"--device", testDevice()});
  endsEarly(arguments, SIGINT, 130);
}

TEST_F(Interruption, SigtermEndsAReferenceRenderWithItsPicture) {
  auto arguments = longRender();
  arguments.emplace_back("--reference");
  endsEarly(arguments, SIGTERM, 143);
}

TEST_F(Interruption, BeforeTheFirstPassWritesNothingAndSaysSo) {
  EXPECT_EQ(whileLoading(SIG_DFL, [](Child& child) { child.send(SIGINT); }), 130);
  const std::string err = contents(folder_ / "err.txt");
  EXPECT_NE(err.find("laver: interrupted before the first pass; nothing is written\n"),
            std::string::npos)
      << err;
  EXPECT_EQ(lines(err), 2);  // the other line is the scene's warning
  EXPECT_EQ(files(), std::set<std::string>{"scene.xml"});
}

// The driver takes minutes to compile the sums of such a filter, and no call of Vulkan ends that.
TEST_F(Interruption, EndsWhileTheDriverCompiles) {
  write("wide.xml",
        "<scene><integrator type=\"depth\"/><camera type=\"perspective\">"
        "<rfilter type=\"gaussian\"><float name=\"radius\" "
        "value=\"58\"/></rfilter></camera></scene>");
  for (const int signal : {SIGTERM, SIGINT}) {
    fs::remove(folder_ / "out.txt");
    Child child(folder_, {"wide.xml", "--size", "32x32", "-o", "a.exr"});
    while (contents(folder_ / "out.txt").find("Rendering") == std::string::npos) ::usleep(1000);
    child.send(signal);
    EXPECT_EQ(child.wait(), 128 + signal);
    EXPECT_EQ(contents(folder_ / "err.txt"),
              "laver: interrupted before the first pass; nothing is written\n");
    EXPECT_EQ(files(), (std::set<std::string>{"wide.xml"}));
  }
}

TEST_F(Interruption, ASecondCtrlCEndsAtOnce) {
  ASSERT_EQ(::mkfifo(path("scene.xml").c_str(), 0600), 0);
  Child child(folder_, {"scene.xml", "--reference"});
  while (!hasSigint(child, "SigCgt:") && !child.ended()) ::usleep(1000);
  child.send(SIGINT);
  while (hasSigint(child, "ShdPnd:") && !child.ended()) ::usleep(1000);
  EXPECT_FALSE(child.ended());  // it is waiting for the scene
  EXPECT_FALSE(hasSigint(child, "SigCgt:"));
  child.send(SIGINT);
  if (!HasFailure()) {
    EXPECT_EQ(child.wait(), -SIGINT);
  }
}

TEST_F(Interruption, AnIgnoredSignalStaysIgnored) {
  EXPECT_EQ(whileLoading(SIG_IGN, [](Child& child) { child.send(SIGINT); }), 0);
  EXPECT_TRUE(fs::exists(path("a.exr")));
}

/// Number of rows from the top in which `image` equals `whole` bit for bit.
int equalRows(const Image& image, const Image& whole) {
  const auto [here, there] =
      std::mismatch(image.pixels.begin(), image.pixels.end(), whole.pixels.begin());
  return static_cast<int>((here - image.pixels.begin()) / (std::ptrdiff_t{3} * image.width));
}

TEST(Stop, LeavesBothRenderersWithTheSamePartOfTheSamples) {
  // The reference takes 2^18 samples at once: 64 per pixel of 64 x 64.
  const Scene scene = smallScene("cornell-two-lights.xml", 64, 192);
  ASSERT_EQ(scene.camera.height, 64);
  const Rendered reference = Reference(scene).render(StopAfter(2).options());
  EXPECT_EQ(reference.reached.samples, 128U);
  EXPECT_EQ(reference.reached.rows, 64);
  EXPECT_EQ(reference.reached.wholeRows, 0);

  VulkanOptions vulkan = onTestDevice();
  vulkan.samplesInFlight = 131072;  // 32 per pixel
  Stats stats;
  const auto [image, reached, dropped] =
      Renderer(vulkan).render(scene, StopAfter(4).options(), stats);
  EXPECT_EQ(reached.samples, 128U);
  EXPECT_EQ(reached.rows, 64);
  EXPECT_EQ(reached.wholeRows, 0);
  EXPECT_EQ(stats.samples, 64U * 64U * 128U);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    ASSERT_NEAR(image.pixels[i], reference.image.pixels[i], 1e-3F) << i;
}

TEST(Stop, LeavesVulkansBandsWholeOrPartOrBlack) {
  const Scene scene = smallScene("cornell-two-lights.xml", 64, 32);
  VulkanOptions vulkan = onTestDevice();
  vulkan.samplesInFlight = 10240;  // bands of some rows, eight samples per pass
  Renderer renderer(vulkan);
  Stats all;
  const Image whole = renderer.render(scene, {}, all).image;
  ASSERT_GT(all.bands, 2U);
  EXPECT_EQ(all.passes, 4 * all.bands);
  for (const int passes : {0, 1, 4, 6, static_cast<int>(all.passes)}) {
    Stats stats;
    const auto [image, r, dropped] = renderer.render(scene, StopAfter(passes).options(), stats);
    EXPECT_EQ(stats.passes, static_cast<unsigned>(passes));
    EXPECT_EQ(r.samples, passes == 0 ? 0U : passes == 6 ? 16U : passes == 1 ? 8U : 32U);
    const int bands = (passes + 3) / 4;
    EXPECT_EQ(stats.bands, static_cast<unsigned>(bands));
    EXPECT_EQ(r.rows == 0, passes == 0);
    EXPECT_EQ(r.rows == 64, stats.passes == all.passes);
    EXPECT_EQ(r.wholeRows < r.rows, passes % 4 != 0);
    EXPECT_EQ(std::max(equalRows(image, whole), r.wholeRows), equalRows(image, whole));
    for (int y = 0; y < 64; ++y) {
      float sum = 0;
      for (int x = 0; x < 64; ++x) sum += image.at(x, y, 0);
      EXPECT_EQ(sum > 0.0F, y < r.rows) << y;
    }
  }
}

TEST(Stop, LeavesTheReferencesBandsWholeOrBlack) {
  // A film this wide has bands of 16 rows.
  Scene scene = smallScene("cornell-two-lights.xml", 64, 1);
  scene.integrator = {&integrators::normals};
  scene.camera.width = 16400;
  scene.camera.height = 18;
  const Reference reference(scene);
  const Image whole = reference.render().image;
  const auto [image, reached, dropped] = reference.render(StopAfter(1).options());
  EXPECT_EQ(reached.samples, 1U);
  EXPECT_EQ(reached.rows, 16);
  EXPECT_EQ(reached.wholeRows, 16);
  EXPECT_GE(equalRows(image, whole), 16);
  for (int y = 16; y < 18; ++y)
    for (int x = 0; x < 16400; ++x) ASSERT_EQ(image.at(x, y, 0), 0.0F);
  const Rendered none = reference.render(StopAfter(0).options());
  EXPECT_EQ(none.reached.rows, 0);
  EXPECT_EQ(none.image.pixels, std::vector<float>(image.pixels.size(), 0.0F));
}

}  // namespace
}  // namespace laver::test
