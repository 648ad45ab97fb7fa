// The window as its user sees it: on an X server, by the contents of the screen, by keys and the
// close button.
#include <algorithm>
#include <chrono>
#include <functional>
#include <set>

#include "image/compare.h"
#include "image/false_colour.h"
#include "image/io.h"
#include "image/srgb.h"
#include "pictures/child.h"
#include "pictures/command_line.h"
#include "pictures/harness.h"
#include "window/screen.h"

namespace laver::test {
namespace {

/// Exceeding it means a hang: a window appears within some seconds.
constexpr std::chrono::minutes kPatience{3};

Bitmap srgb(const Image& image) {
  Bitmap bitmap(image.width, image.height, {});
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) bitmap.at(x, y)[c] = srgb8(image.at(x, y, c));
  return bitmap;
}

/// Whether `whole` contains `part` as a rectangle.
bool holds(const Bitmap& whole, const Bitmap& part) {
  const auto fits = [&](std::ptrdiff_t x0, std::ptrdiff_t y0) {
    for (std::ptrdiff_t y = 0; y < part.height; ++y) {
      const auto row = part.pixels.begin() + y * part.width;
      const auto there = whole.pixels.begin() + (y0 + y) * whole.width + x0;
      if (!std::equal(row, row + part.width, there)) return false;
    }
    return true;
  };
  for (int y = 0; y + part.height <= whole.height; ++y)
    for (int x = 0; x + part.width <= whole.width; ++x)
      if (fits(x, y)) return true;
  return false;
}

class WindowTest : public CommandLine {
 protected:
  /// Waits until the window's contents satisfy `wished`; false if they never do.
  bool sees(Child& child, const std::function<bool(const Bitmap&)>& wished) const {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!child.ended() && std::chrono::steady_clock::now() < end) {
      const auto window = screen_.window();
      if (window && wished(*window)) return true;
      ::usleep(20000);
    }
    return false;
  }
  bool shows(Child& child, const Bitmap& picture) const {
    return sees(child, [&](const Bitmap& window) { return holds(window, picture); });
  }
  std::string err() const { return contents(folder_ / "err.txt"); }

  Screen screen_;
};

std::vector<std::string> cornell(std::vector<std::string> more) {
  std::vector<std::string> all = {(scenesFolder() / "cornell-two-lights.xml").string(),
                                  "--gui",
                                  "--device",
                                  testDevice(),
                                  "--size",
                                  "96x64",
                                  "-q",
                                  "-o",
                                  "a.exr"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

TEST_F(WindowTest, ShowsWhatIsRenderedAndWritten) {
  Child child(folder_, cornell({"--spp", "4", "--layers", "normals"}));
  // The file exists before the window is closed, and the window shows it.
  ASSERT_TRUE(sees(child, [&](const Bitmap&) { return fs::exists(path("a.exr")); })) << err();
  const Image picture = readExr(path("a.exr"));
  EXPECT_TRUE(shows(child, srgb(picture)));
  screen_.type('l');  // the next layer
  Image normals = rgbImage(picture.width, picture.height);
  const auto first =
      static_cast<std::size_t>(std::find(picture.channels.begin(), picture.channels.end(), "N.X") -
                               picture.channels.begin());
  ASSERT_LE(first + 3, picture.channels.size());
  for (std::size_t i = 0; i < normals.pixels.size(); ++i)
    normals.pixels[i] = picture.pixels[i / 3 * picture.channels.size() + first + i % 3];
  EXPECT_TRUE(shows(child, srgb(normals)));
  EXPECT_FALSE(child.ended());
  screen_.close();
  EXPECT_EQ(child.wait(), 0) << err();
  EXPECT_EQ(err(), "");
  EXPECT_EQ(files(), (std::set<std::string>{"a.exr", "a.png"}));
}

TEST_F(WindowTest, ClosedEarlyKeepsThePartialPicture) {
  Child child(folder_, cornell({"--spp", "1048576"}));
  // Before the first pass there are only two colours, black and the surround.
  ASSERT_TRUE(sees(child, [](const Bitmap& window) {
    const auto end = window.pixels.begin() + std::ptrdiff_t{window.width} * (window.height * 2 / 3);
    return std::set<Rgb8>(window.pixels.begin(), end).size() > 50;
  })) << err();
  screen_.close();
  EXPECT_EQ(child.wait(), 130) << err();
  EXPECT_NE(err().find("laver: interrupted with "), std::string::npos) << err();
  EXPECT_TRUE(fs::exists(path("a.partial.exr")));
  EXPECT_TRUE(fs::exists(path("a.partial.png")));
  EXPECT_FALSE(fs::exists(path("a.exr")));
}

TEST_F(WindowTest, ViewsFlipsAndSubtracts) {
  Image a = rgbImage(40, 30), b = rgbImage(40, 30);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    a.pixels[i] = static_cast<float>(i) / 3600.0F;
    b.pixels[i] = a.pixels[i] + (i % 7 == 0 ? 1e-3F : 0.0F);
  }
  writeExr(path("a.exr"), a);
  writeExr(path("b.exr"), b);
  Child child(folder_, {"view", "a.exr", "b.exr"});
  EXPECT_TRUE(shows(child, srgb(a))) << err();
  screen_.type('b');
  EXPECT_TRUE(shows(child, srgb(b)));
  screen_.type('d');
  const std::vector<double> distances = largestDistances(a, b);
  Bitmap difference(40, 30, {});
  for (std::size_t i = 0; i < distances.size(); ++i)
    difference.pixels[i] = falseColour(distances[i], LogScale{});
  EXPECT_TRUE(shows(child, difference));
  screen_.type('a');
  screen_.type('e');
  screen_.type('e');  // two half stops
  for (float& value : a.pixels) value *= 2.0F;
  EXPECT_TRUE(shows(child, srgb(a)));
  screen_.type('q');
  EXPECT_EQ(child.wait(), 0) << err();
}

TEST_F(WindowTest, ViewsAFileByItsName) {
  Image a = rgbImage(16, 16);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) a.pixels[i] = static_cast<float>(i % 97) / 97;
  writeExr(path("a.exr"), a);
  Child child(folder_, {"a.exr"});
  EXPECT_TRUE(shows(child, srgb(a))) << err();
  screen_.close();
  EXPECT_EQ(child.wait(), 0) << err();
}

TEST_F(WindowTest, AnErrorClosesIt) {
  write("a.xml", kFirstScene);
  // The file cannot be written at the end of the render.
  Child child(folder_, {"a.xml", "--reference", "--gui", "-q", "--stats=/nowhere/a.json"});
  EXPECT_EQ(child.wait(), 1);
  EXPECT_NE(err().find("/nowhere/a.json"), std::string::npos) << err();
}

}  // namespace
}  // namespace laver::test
