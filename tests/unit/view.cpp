// The contents of a window, computed without one.
#include "show/view.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "image/compare.h"
#include "image/false_colour.h"
#include "image/srgb.h"
#include "show/compose.h"
#include "show/view_layers.h"
#include "show/viewed_pictures.h"

namespace laver::test {
namespace {

std::vector<std::string> namesOf(const std::vector<ViewLayer>& layers) {
  std::vector<std::string> names;
  names.reserve(layers.size());
  for (const ViewLayer& layer : layers) names.push_back(layer.name);
  return names;
}

ViewContext context(glm::ivec2 picture, glm::ivec2 window, glm::dvec2 cursor) {
  ViewContext all;
  all.picture = picture;
  all.window = window;
  all.cursor = cursor;
  return all;
}

/// Distinct values in every channel of every pixel, from 0 on.
Image ramp(int width, int height, std::vector<std::string> channels) {
  Image image = blackImage(width, height, std::move(channels));
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<float>(i) / static_cast<float>(image.pixels.size());
  return image;
}

const ViewLayer kRgb{"RGB", {0, 1, 2}};

TEST(ViewLayers, GroupsByPrefixAndSeparatesTheRest) {
  const auto layers = viewLayers({"R", "G", "B", "A", "u", "v", "Z", "N.X", "N.Y", "N.Z", "depth.R",
                                  "depth.G", "depth.B", "shape_index", "P.X"});
  EXPECT_EQ(namesOf(layers),
            (std::vector<std::string>{"RGB", "A", "uv", "Z", "N", "depth", "shape_index", "P.X"}));
  EXPECT_EQ(layers[4].channels, (std::vector<std::size_t>{7, 8, 9}));
  EXPECT_EQ(layers[7].channels, std::vector<std::size_t>{14});
}

TEST(ViewLayers, OrdersTheChannelsOfAGroupAndNeedsAllOfThem) {
  EXPECT_EQ(viewLayers({"B", "G", "R"})[0].channels, (std::vector<std::size_t>{2, 1, 0}));
  EXPECT_EQ(namesOf(viewLayers({"R", "G"})), (std::vector<std::string>{"R", "G"}));
}

TEST(ViewLayers, OfTwoPicturesAreTheSharedOnes) {
  Image a = ramp(3, 2, {"R", "G", "B", "Z"}), b = ramp(3, 2, {"B", "G", "R", "u"});
  const Image first = a, second = b;
  keepShared(a, b);
  EXPECT_EQ(a.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(b.channels, a.channels);
  EXPECT_EQ(a.at(2, 1, 2), first.at(2, 1, 2));
  EXPECT_EQ(b.at(2, 1, 2), second.at(2, 1, 0));
  Image z = ramp(3, 2, {"Z"}), wide = ramp(4, 2, {"R", "G", "B"});
  EXPECT_THROW(keepShared(a, z), Error);
  EXPECT_THROW(keepShared(a, wide), Error);
}

TEST(View, OpensCentredAtZoomOne) {
  View view;
  view.placement.centre({10, 20}, {31, 40}, false);
  EXPECT_EQ(view.placement.zoom(), 1.0);
  EXPECT_EQ(view.placement.offset(), glm::dvec2(10.0, 10.0));
}

TEST(View, FitsAtTheLargestZoom) {
  View view;
  view.placement.centre({100, 50}, {400, 400}, true);
  EXPECT_EQ(view.placement.zoom(), 4.0);
  EXPECT_EQ(view.placement.offset(), glm::dvec2(0.0, 100.0));
  view.placement.centre({4096, 16}, {1024, 1024}, true);
  EXPECT_EQ(view.placement.zoom(), 0.25);
}

TEST(View, ZoomsAboutTheCursor) {
  View view;
  const ViewContext c = context({100, 100}, {200, 200}, {60.5, 30.5});
  type(view, U'1', c);
  const glm::dvec2 before = view.placement.toPicture(c.cursor);
  for (int i = 0; i < 100; ++i) type(view, U'+', c);
  EXPECT_EQ(view.placement.zoom(), 256.0);
  const glm::dvec2 after = view.placement.toPicture(c.cursor);
  EXPECT_NEAR(after.x, before.x, 1e-9);  // a hundred roundings of numbers below 1e5
  EXPECT_NEAR(after.y, before.y, 1e-9);
  for (int i = 0; i < 100; ++i) type(view, U'-', c);
  EXPECT_EQ(view.placement.zoom(), 1.0 / 256.0);
}

TEST(View, FindsThePixelUnderTheCursor) {
  View view;
  view.placement.pan({5.0, 7.0});
  for (int i = 0; i < 4; ++i) view.placement.zoomAt({5.0, 7.0}, 1);  // four window pixels each
  const auto at = [&](double x, double y) {
    return pixelUnderCursor(view, context({3, 2}, {100, 100}, {x, y}));
  };
  EXPECT_EQ(at(5.0, 7.0), glm::ivec2(0, 0));
  EXPECT_EQ(at(8.9, 11.0), glm::ivec2(0, 1));
  EXPECT_EQ(at(16.9, 14.9), glm::ivec2(2, 1));
  EXPECT_FALSE(at(17.0, 14.9));
  EXPECT_FALSE(at(4.9, 7.0));
  EXPECT_FALSE(at(8.0, 15.0));
}

TEST(View, KeysCycleLayersAndFlipPictures) {
  View view;
  ViewContext c = context({10, 10}, {10, 10}, {});
  c.layers = 3;
  type(view, U'L', c);
  EXPECT_EQ(view.layer, 2U);
  type(view, U'l', c);
  EXPECT_EQ(view.layer, 0U);
  type(view, U'd', c);
  EXPECT_EQ(view.mode, View::Mode::A);  // there is no picture B
  c.two = true;
  type(view, U' ', c);
  EXPECT_EQ(view.mode, View::Mode::B);
  type(view, U' ', c);
  EXPECT_EQ(view.mode, View::Mode::A);
  type(view, U'd', c);
  EXPECT_EQ(view.mode, View::Mode::Difference);
  type(view, U'E', c);
  EXPECT_EQ(view.halfStops, -1);
  type(view, U'r', c);
  EXPECT_EQ(view.halfStops, 0);
  const View same = view;
  type(view, U'?', c);
  EXPECT_EQ(view, same);
}

TEST(Compose, ShowsEachPixelAsInThePng) {
  const Image image = ramp(9, 5, {"R", "G", "B"});
  View view;
  view.placement.pan({2.0, 3.0});
  Bitmap seen = compose(image, nullptr, kRgb, view, 20, 12);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 20; ++x) {
      const bool inside = x >= 2 && x < 11 && y >= 3 && y < 8;
      for (std::size_t c = 0; c < 3; ++c)
        ASSERT_EQ(seen.at(x, y)[c], inside ? srgb8(image.at(x - 2, y - 3, c)) : kSurround[c]);
    }
}

TEST(Compose, AppliesExposureAndStretch) {
  const Image image = ramp(4, 4, {"Z"});
  View view;
  view.halfStops = 2;
  EXPECT_EQ(compose(image, nullptr, {"Z", {0}}, view, 4, 4).at(3, 1)[2],
            srgb8(2.0F * image.at(3, 1, 0)));
  view.halfStops = 0;
  view.spread = true;
  Bitmap seen = compose(image, nullptr, {"Z", {0}}, view, 4, 4);
  EXPECT_EQ(seen.at(0, 0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(seen.at(3, 3), (Rgb8{255, 255, 255}));
}

TEST(Compose, EnlargesToBlocksAndShrinksToMeans) {
  const Image image = ramp(4, 4, {"R", "G", "B"});
  View view;
  view.placement.zoomAt({}, 4);
  Bitmap large = compose(image, nullptr, kRgb, view, 16, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) ASSERT_EQ(large.at(x, y)[1], srgb8(image.at(x / 4, y / 4, 1)));
  view.placement.zoomAt({}, -6);
  ASSERT_EQ(view.placement.zoom(), 0.5);
  Bitmap small = compose(image, nullptr, kRgb, view, 2, 2);
  const float mean =
      (image.at(2, 0, 1) + image.at(3, 0, 1) + image.at(2, 1, 1) + image.at(3, 1, 1)) / 4.0F;
  EXPECT_EQ(small.at(1, 0)[1], srgb8(mean));
}

TEST(Compose, DrawsTheLargestDifferenceAsCompareDoes) {
  const Image a = ramp(4, 4, {"R", "G", "B"});
  Image b = a;
  b.at(1, 2, 0) += 1e-3F;
  b.at(1, 2, 2) -= 0.125F;
  b.at(3, 3, 1) = std::numeric_limits<float>::quiet_NaN();
  View view;
  view.mode = View::Mode::Difference;
  Bitmap seen = compose(a, &b, kRgb, view, 4, 4);
  EXPECT_EQ(seen.at(0, 0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(seen.at(1, 2), falseColour(largestDistances(a, b)[9], LogScale{}));
  EXPECT_EQ(seen.at(3, 3), (Rgb8{255, 0, 255}));
  view.placement.zoomAt({}, -2);  // two by two to one
  EXPECT_EQ(compose(a, &b, kRgb, view, 2, 2).at(0, 1), seen.at(1, 2));
  view.mode = View::Mode::B;
  EXPECT_EQ(compose(a, &b, kRgb, View{.mode = View::Mode::B}, 4, 4).at(1, 2)[0],
            srgb8(b.at(1, 2, 0)));
}

TEST(ViewedPictures, TakesRowsAndFinallyAll) {
  ViewedPictures pictures;
  pictures.add("a", rgbImage(3, 3));
  const Image picture = ramp(3, 3, {"R", "G", "B"});
  pictures.rowsChanged(picture, 1, 2);
  pictures.read([&](const ViewedPictures::Contents& contents) {
    EXPECT_EQ(contents.changes, 1U);
    const Image& seen = contents.images[0];
    EXPECT_EQ(seen.at(2, 0, 2), 0.0F);
    EXPECT_EQ(seen.at(2, 1, 2), picture.at(2, 1, 2));
    EXPECT_EQ(seen.at(0, 2, 0), 0.0F);
  });
  pictures.replace(ramp(3, 3, {"R", "G", "B", "Z"}));
  pictures.read([](const auto& contents) {
    EXPECT_EQ(contents.images[0].channels.size(), 4U);
    EXPECT_EQ(contents.changes, 2U);
  });
}

}  // namespace
}  // namespace laver::test
