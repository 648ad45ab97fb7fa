#include "render/strips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "render/tiling.h"

namespace laver::test {
namespace {

Scene sceneOf(int height, double radius) {
  Scene scene;
  scene.camera.width = 9;
  scene.camera.height = height;
  scene.filter.radius = radius;
  return scene;
}

std::vector<Strip> stripsOf(const Scene& scene, int index, int count) {
  RenderOptions options;
  options.shard = Shard{index, count};
  return laver::stripsOf(scene, options);
}

TEST(Strips, OfAllShardsAreEveryRowOnce) {
  for (const double radius : {0.5, 2.0, 4.0})
    for (const int height : {7, 48, 321, 1080, 4000})
      for (const int count : {1, 2, 3, 7}) {
        const Scene scene = sceneOf(height, radius);
        std::vector<int> rows;
        for (int i = 0; i < count; ++i) {
          int row = 0;
          for (const Strip& strip : stripsOf(scene, i, count)) {
            EXPECT_EQ(strip.row, row);
            row += strip.rows();
            for (int y = strip.pixels.y0; y < strip.pixels.y1; ++y) rows.push_back(y);
          }
        }
        std::sort(rows.begin(), rows.end());
        std::vector<int> all(static_cast<std::size_t>(height));
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(rows, all) << height << ' ' << count;
      }
}

TEST(Strips, AreEqualWorkAlsoWhereTheCostGrowsDownwards) {
  const Scene scene = sceneOf(1080, 2.0);
  double least = 1e9, most = 0, fewest = 1e9, mostRows = 0;
  for (int i = 0; i < 8; ++i) {
    double cost = 0, rows = 0;
    for (const Strip& strip : stripsOf(scene, i, 8))
      for (int y = strip.pixels.y0; y < strip.pixels.y1; ++y, ++rows) cost += y;
    least = std::min(least, cost);
    most = std::max(most, cost);
    fewest = std::min(fewest, rows);
    mostRows = std::max(mostRows, rows);
  }
  // Two strips of each turn differ by a row at most, which is a 27th of them here.
  EXPECT_LE(mostRows - fewest, 2);
  EXPECT_LE(most / least, 1.03);
}

TEST(Strips, SpendAtMostATenthOnAprons) {
  for (const double radius : {0.5, 2.0, 4.0}) {
    const Scene scene = sceneOf(2000, radius);
    const int apron = static_cast<int>(apronOf(radius));
    for (int i = 0; i < 4; ++i)
      for (const Strip& strip : stripsOf(scene, i, 4)) EXPECT_LE(2 * apron * 10, strip.rows());
    EXPECT_GT(stripsOf(scene, 0, 4).size(), 1U);
  }
}

TEST(Strips, ThatAreAdjacentAreOne) {
  const Scene scene = sceneOf(1080, 2.0);
  EXPECT_EQ(stripsOf(scene, 0, 1).size(), 1U);
  const auto strips = stripsOf(scene, 7, 8);
  for (std::size_t i = 1; i < strips.size(); ++i)
    EXPECT_GT(strips[i].pixels.y0, strips[i - 1].pixels.y1);
}

TEST(Strips, OfACropLieInIt) {
  RenderOptions options;
  options.crop = Crop{2, 10, 7, 30};
  options.shard = Shard{1, 2};
  const auto strips = laver::stripsOf(sceneOf(48, 2.0), options);
  ASSERT_EQ(strips.size(), 1U);
  EXPECT_EQ(strips[0].pixels.x0, 2);
  EXPECT_EQ(strips[0].pixels.x1, 7);
  EXPECT_EQ(strips[0].pixels.y0, 20);
  EXPECT_EQ(strips[0].pixels.y1, 30);
}

}  // namespace
}  // namespace laver::test
