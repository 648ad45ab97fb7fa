// The integrators av and ao: lengths, all traversals, crops.
#include "pictures/explain.h"
#include "pictures/harness.h"
#include "support/bumpy_sphere.h"

namespace laver::test {
namespace {

/// The inside of a bumpy sphere in a wide view: rays in all directions.
Scene insideASphere(const IntegratorRow& integrator) {
  Scene scene;
  scene.integrator = {&integrator};
  scene.meshes = {bumpySphere(60, 90, 0.05, glm::dvec3(0.1, 0.0, 0.0)),
                  bumpySphere(12, 20, 0.0, glm::dvec3(0.1, 0.0, 9.0))};
  for (glm::dvec3& p : scene.meshes[1].positions) p = 0.3 * (p - glm::dvec3(0.1, 0.0, 9.0));
  for (glm::uvec3& t : scene.meshes[0].triangles) std::swap(t.x, t.y);  // seen from inside
  scene.camera.width = 61;
  scene.camera.height = 40;
  scene.camera.fov = 150.0;
  scene.camera.toWorld[3] = glm::dvec4(0.0, 0.0, -0.7, 1.0);
  scene.sampler.sampleCount = 3;
  return scene;
}

TEST(Occlusion, EveryLengthEqualsTheReference) {
  Scene scene = insideASphere(integrators::averageVisibility);
  double before = 1.0;
  for (const double length : {1e-30, 1e-6, 1e-3, 0.1, 0.7, 2.0, 1e30}) {
    SCOPED_TRACE(length);
    scene.integrator.set("length", length);
    expectTraversalsMatch(scene, 1e-4);
    const double now = meanOf(render(scene));
    EXPECT_LE(now, before);
    before = now;
  }
  EXPECT_EQ(before, 0.0);  // nothing leaves the sphere
  scene.integrator.set("length", 1e-9);
  EXPECT_GT(meanOf(render(scene)), 0.999);
}

TEST(Occlusion, AmbientOcclusionFromOutsideEqualsTheReference) {
  Scene scene = insideASphere(integrators::ambientOcclusion);
  scene.meshes.erase(scene.meshes.begin());
  scene.meshes.push_back(bumpySphere(12, 20, 0.2, glm::dvec3(1.0, 0.5, 0.4)));
  expectTraversalsMatch(scene, 1e-4);
  EXPECT_GT(meanOf(render(scene)), 0.1);
}

TEST(Occlusion, LengthIsInSceneUnits) {
  Scene scene = smallScene("curved-av.xml", 64, 2);
  const Image image = render(scene);
  const double k = 1024.0;  // a power of two: the same bits
  for (Mesh& mesh : scene.meshes)
    for (glm::dvec3& p : mesh.positions) p *= k;
  for (int i = 0; i < 3; ++i) scene.camera.toWorld[3][i] *= k;
  scene.camera.nearClip *= k;
  scene.camera.farClip *= k;
  scene.integrator.set("length", k * scene.integrator.real("length"));
  EXPECT_EQ(differingFloats(image, render(scene)), 0U);
}

TEST(Occlusion, PassesAndCropsKeepTheNumbers) {
  const Scene scene = smallScene("cornell-ao.xml", 70, 5);
  const Image whole = render(scene);
  VulkanOptions pieces = onTestDevice();
  pieces.samplesInFlight = std::uint64_t{70} * 7;
  EXPECT_EQ(differingFloats(whole, render(scene, pieces)), 0U);
  RenderOptions options;
  options.crop = Crop{31, 30, 70, 66};
  const Image part = render(scene, onTestDevice(), options);
  for (int y = 30; y < 66; ++y)
    for (int x = 31; x < 70; ++x)
      for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(part.at(x - 31, y - 30, c), whole.at(x, y, c));
}

}  // namespace
}  // namespace laver::test
