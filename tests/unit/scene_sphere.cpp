// Meshes of type "sphere" in the reader and in the reference.
#include <numbers>

#include "support/scene_files.h"
#include "unit/reference_seen.h"

namespace laver::test {
namespace {

TEST(SceneSphere, HasItsCentreRadiusAndMaterial) {
  const SceneFiles files;
  const Scene s = files
                      .load(scene("<mesh type=\"sphere\"><point name=\"center\" value=\"1, 2, 3\"/>"
                                  "<float name=\"radius\" value=\"0.5\"/><bsdf type=\"diffuse\">"
                                  "<color name=\"albedo\" value=\"0.1 0.2 0.3\"/></bsdf></mesh>"
                                  "<mesh type=\"sphere\"/>"))
                      .scene;
  ASSERT_EQ(s.meshes.size(), 2U);
  EXPECT_EQ(s.meshes[0].sphere->centre, glm::dvec3(1, 2, 3));
  EXPECT_EQ(s.meshes[0].sphere->radius, 0.5);
  EXPECT_EQ(s.meshes[0].bsdf.color("albedo"), glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(s.meshes[1].sphere->centre, glm::dvec3(0));
  EXPECT_EQ(s.meshes[1].sphere->radius, 1.0);
  EXPECT_NE(describe(s).find("    Sphere[\n      center = [1, 2, 3],\n      radius = 0.5,\n"),
            std::string::npos);
}

TEST(SceneSphere, NeedsARadiusAboveZeroAndTakesNoTransform) {
  const SceneFiles files;
  EXPECT_EQ(
      files.errors(scene("<mesh type=\"sphere\"><float name=\"radius\" value=\"-1\"/></mesh>")),
      "f.xml:2:22: error: radius must be more than 0, found -1");
  EXPECT_EQ(files.warnings(scene("<mesh type=\"sphere\"><transform name=\"toWorld\"/></mesh>")),
            "f.xml:2:22: warning: mesh \"sphere\" has no property \"toWorld\": ignored; it takes "
            "\"center\" or \"radius\"");
}

/// A sphere under a light, seen from above; a square far below moves the centre of the meshes.
Scene litSphere(const IntegratorRow& integrator) {
  Scene s;
  s.integrator = {&integrator};
  s.meshes.resize(1);
  s.meshes[0].sphere = Sphere{{0.5, 0.0, 0.0}, 0.25};
  s.meshes[0].bsdf.set("albedo", glm::dvec3(0.2, 0.5, 0.8));
  s.meshes.push_back(square(3, -2));
  s.camera = downCamera({0.5, 0, 4}, 60, 64);
  s.lights = {{{0.5, 0, 2.25}, {4, 8, 12}}};
  return s;
}

TEST(ReferenceSphere, DepthNormalsAndLightAtItsTop) {
  const glm::dvec3 top(0.5, 0, 0.25);
  expectNear(seenAt(litSphere(integrators::depth), top), glm::dvec3(1 / 3.75));
  expectNear(seenAt(litSphere(integrators::normals), top), glm::dvec3(0, 0, 1));
  expectNear(seenAt(litSphere(integrators::directWhitted), top),
             glm::dvec3(0.2, 1.0, 2.4) / std::numbers::pi);
}

TEST(ReferenceSphere, NormalsOffCentreAndTheSquareBehind) {
  // The line from (0, 0, 4) through a point at (0.6, 0.8) of the radius from the centre.
  const Scene s = litSphere(integrators::normals);
  const glm::dvec3 n(0.28, 0.0, 0.96);
  const glm::dvec3 seen = seenAt(s, glm::dvec3(0.5, 0, 0) + 0.25 * n);
  expectNear(seen, n, 1e-13);
  expectNear(seenAt(s, {2, 0, -2}), glm::dvec3(0, 0, 1));
}

TEST(ReferenceSphere, ShadowsTheFloorAndNotItself) {
  const Scene s = litSphere(integrators::directWhitted);
  Scene below = s;
  below.camera = downCamera({0.5, 0, -1}, 60, 64);
  EXPECT_EQ(seenAt(below, {0.6, 0, -2}), glm::dvec3(0));
  EXPECT_GT(seenAt(s, {1.9, 0, -2}).x, 0.0);
  // From the light, the sphere's outline is at cos = r / d from its centre.
  EXPECT_GT(seenAt(s, {0.5 + 0.25 * std::sin(1.4), 0, 0.25 * std::cos(1.4)}).x, 0.0);
}

TEST(ReferenceSphere, TextureCoordinatesAreLongitudeAndLatitudeOfTheNormal) {
  using glm::dvec2;
  using glm::dvec3;
  const double h = std::sqrt(0.5);
  const std::pair<dvec3, dvec2> cases[] = {{{1, 0, 0}, {0.5, 0.5}},   {{0, 1, 0}, {0.75, 0.5}},
                                           {{0, -1, 0}, {0.25, 0.5}}, {{0, 0, 1}, {0.5, 1.0}},
                                           {{0, 0, -1}, {0.5, 0.0}},  {{h, 0, h}, {0.5, 0.75}},
                                           {{h, h, 0}, {0.625, 0.5}}, {{-h, h, 0}, {0.875, 0.5}}};
  for (const auto& [n, uv] : cases) {
    SCOPED_TRACE(testing::Message() << n.x << " " << n.y << " " << n.z);
    Scene s = litSphere(integrators::albedo);
    // A camera that looks at that point from another direction.
    const dvec3 point = s.meshes[0].sphere->centre + 0.25 * n;
    const dvec3 forward = -glm::normalize(n + dvec3(0.1, 0.2, 0.15));
    const dvec3 side = glm::normalize(glm::cross(dvec3(0.3, 0.5, 0.7), forward));
    s.camera.toWorld = glm::dmat4(glm::dvec4(side, 0), glm::dvec4(glm::cross(forward, side), 0),
                                  glm::dvec4(forward, 0), glm::dvec4(point - 0.9 * forward, 1));
    const dvec2 middle(32, 32);
    const auto hit = Reference(s).centre(middle);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(glm::distance(hit->position, point), 0.0, 1e-12);
    EXPECT_NEAR(hit->distance, 0.9, 1e-12);
    EXPECT_EQ(hit->mesh, 0U);
    EXPECT_EQ(hit->triangle, 0U);
    EXPECT_NEAR(hit->uv.y, uv.y, 1e-7);  // asin is steep at the poles
    if (std::abs(n.z) < 1.0) {
      EXPECT_NEAR(hit->uv.x, uv.x, 1e-12);
    }
    // The texture is evaluated there.
    s.meshes[0].bsdf.show("albedo", Texture());
    Texture& texture = *s.meshes[0].bsdf.texture("albedo");
    texture.scale = {0.0, 5.0};
    texture.offset = {0.0, 0.1};
    const bool odd = static_cast<int>(uv.y * 5.0 + 0.1) % 2 != 0;
    EXPECT_EQ(Reference(s).radiance(middle), texture.colors[odd ? 1 : 0]);
  }
}

TEST(ReferenceSphere, FromInsideItIsSeenAllAround) {
  Scene s = litSphere(integrators::depth);
  s.camera = test::downCamera({0.5, 0, 0.0}, 120, 64);
  EXPECT_NEAR(Reference(s).radiance({32, 32}).x, 4.0, 1e-12);
  EXPECT_NEAR(Reference(s).radiance({3, 60}).x, 4.0, 1e-12);
}

}  // namespace
}  // namespace laver::test
