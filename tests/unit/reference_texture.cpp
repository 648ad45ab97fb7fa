// The reference's textures and backgrounds against values computed by hand.
#include <gtest/gtest.h>

#include "reference/texture.h"
#include "unit/reference_seen.h"

namespace laver::test {
namespace {

using glm::dvec2;
using glm::dvec3;
using reference::albedoAt;

std::shared_ptr<const Picture> floats(int width, int height, const std::vector<float>& red) {
  Image image = rgbImage(width, height);
  for (std::size_t i = 0; i < red.size(); ++i) image.pixels[3 * i] = red[i];
  return std::make_shared<const Picture>(std::move(image));
}

Bsdf showing(std::shared_ptr<const Picture> picture) {
  Texture texture;
  texture.row = &textures::bitmap;
  texture.colors.fill(dvec3(1.0));
  texture.image = std::move(picture);
  return {.textures = {{"albedo", texture}}};
}

TEST(ReferenceTexture, NoTextureIsTheAlbedo) {
  EXPECT_EQ(albedoAt({.values = {{"albedo", dvec3(0.1, 0.2, 0.3)}}}, {7, 8}), dvec3(0.1, 0.2, 0.3));
}

TEST(ReferenceTexture, TheRowsOfAPictureGoDown) {
  const Bsdf bsdf = showing(floats(2, 2, {1, 2, 3, 4}));
  EXPECT_EQ(albedoAt(bsdf, {0.25, 0.75}).x, 1.0);
  EXPECT_EQ(albedoAt(bsdf, {0.75, 0.75}).x, 2.0);
  EXPECT_EQ(albedoAt(bsdf, {0.25, 0.25}).x, 3.0);
  EXPECT_EQ(albedoAt(bsdf, {0.75, 0.25}).x, 4.0);
  EXPECT_DOUBLE_EQ(albedoAt(bsdf, {0.5, 0.5}).x, 2.5);
  EXPECT_DOUBLE_EQ(albedoAt(bsdf, {0.25 + 0.125, 0.75}).x, 1.25);
}

TEST(ReferenceTexture, APictureRepeats) {
  const Bsdf bsdf = showing(floats(4, 2, {1, 2, 3, 4, 50, 60, 70, 80}));
  for (const dvec2 uv : {dvec2(0.1, 0.9), dvec2(0.97, 0.02), dvec2(0.0, 0.0), dvec2(0.5, 0.31)})
    for (const dvec2 shift : {dvec2(1, 0), dvec2(0, -1), dvec2(-3, 2), dvec2(1024, -512)})
      EXPECT_NEAR(albedoAt(bsdf, uv + shift).x, albedoAt(bsdf, uv).x, 1e-9) << uv.x << shift.x;
  // At the left edge, between the first and the last column, at the centre of the upper row.
  EXPECT_DOUBLE_EQ(albedoAt(bsdf, {0.0, 0.75}).x, 2.5);
  // At the upper edge, between the first and the last row.
  EXPECT_DOUBLE_EQ(albedoAt(bsdf, {0.125, 1.0}).x, 25.5);
}

TEST(ReferenceTexture, ScaleThenOffsetAndTheFactor) {
  Bsdf bsdf = showing(floats(4, 1, {1, 2, 3, 4}));
  bsdf.texture("albedo")->scale = {2, 1};
  bsdf.texture("albedo")->offset = {0.125, 0};
  bsdf.texture("albedo")->colors[0] = dvec3(10, 1, 1);
  EXPECT_EQ(albedoAt(bsdf, {0.125, 0.3}).x, 20.0);
}

TEST(ReferenceTexture, BytesAreDecodedBeforeInterpolation) {
  Bitmap bitmap(2, 1, {0, 128, 255});
  bitmap.at(1, 0) = {255, 128, 255};
  Bsdf bsdf = showing(std::make_shared<const Picture>(bitmap));
  // The curve of IEC 61966-2-1 at 128 / 255.
  expectNear(albedoAt(bsdf, {0.5, 0.5}), {0.5, 0.21586050011389926, 1.0}, 1e-12);
  bsdf.texture("albedo")->raw = true;
  expectNear(albedoAt(bsdf, {0.5, 0.5}), {0.5, 128 / 255.0, 1.0}, 1e-12);
}

TEST(ReferenceTexture, ACheckerFollowsTheParityOfBothAxes) {
  Bsdf bsdf;
  bsdf.show("albedo", Texture());
  bsdf.texture("albedo")->colors = {dvec3(1), dvec3(2)};
  bsdf.texture("albedo")->scale = {4, 2};
  const auto at = [&](double u, double v) { return albedoAt(bsdf, {u, v}).x; };
  EXPECT_EQ(at(0.1, 0.1), 1.0);
  EXPECT_EQ(at(0.3, 0.1), 2.0);
  EXPECT_EQ(at(0.3, 0.6), 1.0);
  EXPECT_EQ(at(-0.1, 0.1), 2.0);
  EXPECT_EQ(at(-0.1, -0.1), 1.0);
  EXPECT_EQ(at(-0.3, -0.1), 2.0);
}

TEST(ReferenceTexture, ABackgroundRunsAroundYAndDownFromThePole) {
  // Columns begin at -z and continue over +x, +z and -x; two rows.
  Environment sky;
  sky.row = &emitters::environment;
  sky.image = floats(4, 2, {1, 2, 3, 4, 10, 20, 30, 40});
  const auto at = [&](dvec3 d) { return sky.row->background(sky, d).x; };
  EXPECT_DOUBLE_EQ(at({1e-9, 1, -1e-9}), at({1, 1e9, -1}));
  const double half = std::sqrt(2.0);  // 45 degrees up
  EXPECT_NEAR(at({1, half, -1}), 1.0, 1e-12);
  EXPECT_NEAR(at({1, half, 1}), 2.0, 1e-12);
  EXPECT_NEAR(at({-1, half, 1}), 3.0, 1e-12);
  EXPECT_NEAR(at({-1, half, -1}), 4.0, 1e-12);
  EXPECT_NEAR(at({-1, -half, -1}), 40.0, 1e-12);
  EXPECT_NEAR(at({0, 1, -1}), 2.5, 1e-12);  // the seam
  EXPECT_NEAR(at({1e-12, 1, -1}), 2.5, 1e-9);
  EXPECT_NEAR(at({-1e-12, 1, -1}), 2.5, 1e-9);
  EXPECT_NEAR(at({1, 0, -1}), 5.5, 1e-12);  // the horizon
  EXPECT_GE(at({0, 1, 0}), 1.0);
  EXPECT_LE(at({0, 1, 0}), 4.0);
  sky.radiance = dvec3(2.0);
  // A quarter turn that maps +x to -z: the image's +x is seen at the world's -z.
  sky.toWorld = glm::dmat4(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 5, 6, 7, 1);
  EXPECT_NEAR(at({1, half, -1}), 2 * 2.0, 1e-12);
}

TEST(ReferenceTexture, CoordinatesOfTheFileOrTheWeights) {
  Scene scene = litSquare();
  Texture checker;
  checker.colors = {dvec3(1), dvec3(0)};
  checker.scale = {2, 2};
  scene.meshes[0].bsdf.show("albedo", checker);
  const auto lit = [&](double x, double y) { return seenAt(scene, {x, y, 0}).x > 0; };
  // Weights: u is 1 at the second corner of each triangle, v at the third.
  EXPECT_TRUE(lit(-0.5, -1.9));  // u 0.35, v 0.025
  EXPECT_FALSE(lit(1, -1.9));    // u 0.725, v 0.025
  EXPECT_FALSE(lit(-1.5, -1));   // of the other triangle: u 0.125, v 0.75
  scene.meshes[0].uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_TRUE(lit(-1.5, -1));
  EXPECT_TRUE(lit(-1, -1));
  EXPECT_FALSE(lit(1, -1));
  EXPECT_TRUE(lit(1, 1));
  EXPECT_FALSE(lit(-1, 1));
}

TEST(ReferenceTexture, OnlyDirectWhittedShowsTheBackground) {
  Scene scene = litSquare();
  scene.environment = Environment();
  scene.environment->radiance = {1, 2, 3};
  EXPECT_EQ(Reference(scene).radiance({0.5, 0.5}), dvec3(1, 2, 3));
  for (const IntegratorRow* integrator : {&integrators::normals, &integrators::depth}) {
    scene.integrator = {integrator};
    EXPECT_EQ(Reference(scene).radiance({0.5, 0.5}), dvec3(0));
  }
}

}  // namespace
}  // namespace laver::test
