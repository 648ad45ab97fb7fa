// The kernels' triangle test, compiled as C++ from the same text.
#include "shared/triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace laver::test {
namespace {

using namespace shared;

struct Fan {
  vec3 centre;
  std::vector<vec3> rim;
};

Fan randomFan(std::mt19937& random) {
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  Fan fan{vec3(unit(random), unit(random), unit(random)), {}};
  const int corners = 3 + static_cast<int>(random() % 6);
  for (int i = 0; i < corners; ++i) {
    const float angle = 6.2831853F * static_cast<float>(i) / static_cast<float>(corners);
    fan.rim.push_back(fan.centre +
                      0.1F * vec3(std::cos(angle), std::sin(angle), 0.3F * unit(random)));
  }
  return fan;
}

/// Number of triangles of the fan that the ray hits.
int hits(const Fan& fan, vec3 origin, vec3 direction) {
  const Shear shear = shearOf(direction);
  int count = 0;
  for (std::size_t i = 0; i < fan.rim.size(); ++i) {
    const Edges e =
        edgesOf(shear, permute(shear, fan.centre - origin), permute(shear, fan.rim[i] - origin),
                permute(shear, fan.rim[(i + 1) % fan.rim.size()] - origin));
    count += e.inside ? 1 : 0;
  }
  return count;
}

TEST(TriangleTest, NoRayAimedAtASharedVertexOrEdgeIsLost) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  int lost = 0;
  for (int i = 0; i < 200000; ++i) {
    const Fan fan = randomFan(random);
    const vec3 origin = fan.centre + vec3(unit(random), unit(random), 3.0F);
    const vec3 inner = fan.rim[random() % fan.rim.size()];
    const float along = i % 2 == 0 ? 0.0F : 0.5F * (unit(random) + 1.0F) * 0.9F;
    lost += hits(fan, origin, fan.centre + along * (inner - fan.centre) - origin) == 0 ? 1 : 0;
  }
  EXPECT_EQ(lost, 0);
}

TEST(TriangleTest, DepthStaysBetweenTheCorners) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  int inside = 0;
  for (int i = 0; i < 200000; ++i) {
    // Slivers seen at grazing angles, where edge functions give depths far off.
    const vec3 a(unit(random), unit(random), 2.0F), b = a + vec3(1e-4F * unit(random), 1e-5F, 1.0F);
    const vec3 c = a + vec3(1e-4F, 1e-5F * unit(random), unit(random));
    const Shear shear = shearOf(a * 0.4F + b * 0.3F + c * 0.3F);
    const vec3 pa = permute(shear, a), pb = permute(shear, b), pc = permute(shear, c);
    const Edges e = edgesOf(shear, pa, pb, pc);
    if (!e.inside) continue;
    ++inside;
    const float depth = depthOf(e, pa.z, pb.z, pc.z);
    EXPECT_GE(depth, std::min({pa.z, pb.z, pc.z}));
    EXPECT_LE(depth, std::max({pa.z, pb.z, pc.z}));
  }
  EXPECT_GT(inside, 1000);
}

TEST(TriangleTest, DifferenceOfProductsIsAccurateUnderCancellation) {
  // (1 + e)(1 - e) - 1 * 1 = -e^2, which plain products lose completely.
  const float e = 1.0F / 4096.0F / 2.0F;
  EXPECT_EQ(differenceOfProducts(1.0F + e, 1.0F - e, 1.0F, 1.0F), -e * e);
}

TEST(TriangleTest, ShearTakesTheFirstOfEqualAxes) {
  EXPECT_EQ(shearOf({1, 1, 1}).axis, 0U);
  EXPECT_EQ(shearOf({0, -1, 1}).axis, 1U);
  EXPECT_EQ(shearOf({0, 0, -2}).axis, 2U);
  EXPECT_EQ(shearOf({0, 0, -2}).sign, -1.0F);
}

/// blocks() for unpermuted arguments.
bool blocked(vec3 a, vec3 b, vec3 c, vec3 point, vec3 light) {
  const Shear shear = shearOf(light - point);
  const vec3 n = permute(shear, crossProduct(b - a, c - a));
  return blocks(shear, std::abs(alongAxis(light - point, shear.axis)), n,
                dotProduct(n, permute(shear, light - a)), permute(shear, a - point),
                permute(shear, b - point), permute(shear, c - point));
}

TEST(TriangleTest, BlocksOnlyPointsOnBothSides) {
  const vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  const vec3 above(0.2F, 0.2F, 1), below(0.3F, 0.1F, -1), on(0.2F, 0.2F, 0);
  EXPECT_TRUE(blocked(a, b, c, above, below));
  EXPECT_TRUE(blocked(a, b, c, below, above));
  EXPECT_TRUE(blocked(a, c, b, above, below));  // either winding
  EXPECT_FALSE(blocked(a, b, c, above, vec3(0.2F, 0.2F, 0.5F)));
  EXPECT_FALSE(blocked(a, b, c, above, on));
  EXPECT_FALSE(blocked(a, b, c, on, above));
  EXPECT_FALSE(blocked(a, b, c, vec3(2, 2, 1), vec3(2, 2, -1)));  // outside its edges
  EXPECT_FALSE(blocked(a, b, c, above, vec3(0.2F, 0.2F, 3)));     // behind the point
}

}  // namespace
}  // namespace laver::test
