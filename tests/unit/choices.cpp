#include "render/choices.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/compose.h"
#include "kernels/modules.h"
#include "render/packed.h"
#include "render/renderer.h"

namespace laver::test {
namespace {

/// lavapipe's limits, without a device.
DeviceInfo device() {
  DeviceInfo info;
  info.subgroupSize = 8;
  info.shuffles = info.longs = true;
  info.limits.maxStorageBufferRange = info.limits.maxTexelBufferElements = 128U << 20;
  for (auto& count : info.limits.maxComputeWorkGroupCount) count = 65535;
  return info;
}

Choices chosen(const Scene& scene) { return choose(scene, {}, {}, device()); }
TraceKey key(const Scene& scene) { return chosen(scene).pictures.front().key; }

TEST(Choices, AStackOnlyGrowsAndInSteps) {
  EXPECT_EQ(stackFor(64, 1), 64U);
  EXPECT_EQ(stackFor(64, 64), 64U);
  EXPECT_EQ(stackFor(64, 65), 80U);
}

TEST(Choices, FewTrianglesNeedAShallowStack) {
  Scene scene;
  EXPECT_EQ(key(scene).stack, 8U);
  scene.meshes.resize(2);
  for (Mesh& mesh : scene.meshes) mesh.positions.emplace_back(0.0);
  scene.meshes[0].triangles.resize(8);
  EXPECT_EQ(key(scene).stack, 8U);
  scene.meshes[1].triangles.resize(1);
  EXPECT_EQ(key(scene).stack, 16U);
  scene.meshes[1].triangles.resize(1000);
  EXPECT_EQ(key(scene).stack, 64U);
}

TEST(Choices, IndicesAreAsSmallAsTheirLargestNumber) {
  Scene scene;
  scene.integrator = {&integrators::normals};
  scene.meshes.resize(2);
  const auto bytes = [&] { return uploadsOf(scene, {}).indexBytes; };
  EXPECT_EQ(bytes(), 1U);
  // Index 0 is NO_NORMAL.
  scene.meshes[0].normals.resize(200);
  scene.meshes[1].normals.resize(55);
  EXPECT_EQ(bytes(), 1U);
  scene.meshes[1].normals.resize(56);
  EXPECT_EQ(bytes(), 2U);
  scene.meshes[0].normals.resize(65535 - 56);
  EXPECT_EQ(bytes(), 2U);
  scene.meshes[0].normals.resize(65536 - 56);
  EXPECT_EQ(bytes(), 4U);
  scene.integrator = {&integrators::depth};
  EXPECT_EQ(bytes(), 1U);
}

TEST(Choices, WithoutALightNothingIsTraced) {
  Scene scene;
  scene.meshes.resize(1);
  const auto hits = [&](const IntegratorRow& integrator) {
    scene.integrator = {&integrator};
    return key(scene).hits;
  };
  for (const IntegratorRow* row :
       {&integrators::normals, &integrators::depth, &integrators::averageVisibility,
        &integrators::ambientOcclusion, &integrators::shadingNormal, &integrators::albedo})
    EXPECT_TRUE(hits(*row)) << row->name;
  EXPECT_FALSE(hits(integrators::directWhitted));
  scene.environment = Environment();
  EXPECT_TRUE(hits(integrators::directWhitted));
  scene.environment.reset();
  scene.lights.resize(1);
  EXPECT_TRUE(hits(integrators::directWhitted));
}

TEST(Choices, TheFilmIsCutToTheSceneOnlyIfMissesAreBlack) {
  Scene scene;
  const auto cut = [&](const IntegratorRow& integrator) {
    scene.integrator = {&integrator};
    return chosen(scene).pictures.front().blackMiss;
  };
  EXPECT_TRUE(cut(integrators::normals));
  EXPECT_TRUE(cut(integrators::directWhitted));
  EXPECT_FALSE(cut(integrators::averageVisibility));
  const IntegratorRow silent{.name = "normals"};  // does not state what a miss shows
  EXPECT_FALSE(cut(silent));
  scene.environment = Environment();
  EXPECT_FALSE(cut(integrators::directWhitted));
  EXPECT_TRUE(cut(integrators::normals));
}

TEST(Choices, SpheresAreTestedIfThereAreAnyAndRaysAreTraced) {
  Scene scene;
  scene.meshes.resize(9);
  EXPECT_FALSE(key(scene).spheres);
  for (Mesh& mesh : scene.meshes) mesh.sphere = Sphere();
  EXPECT_TRUE(key(scene).spheres);
  EXPECT_EQ(key(scene).stack, 16U);
  scene.integrator = {&integrators::directWhitted};  // the scene has no light
  EXPECT_FALSE(key(scene).spheres);
}

TEST(Choices, UnusedPartsAreLeftOut) {
  Scene scene;
  scene.meshes.resize(2);
  scene.meshes[0].normals.resize(3);
  scene.meshes[1].bsdf.set("albedo", glm::dvec3(0.1));
  scene.lights.resize(1);
  scene.integrator = {&integrators::depth};
  EXPECT_FALSE(key(scene).normals || key(scene).materials || key(scene).lights);
  EXPECT_TRUE(key(scene).bsdfs.empty());
  scene.integrator = {&integrators::normals};
  EXPECT_TRUE(key(scene).normals);
  EXPECT_FALSE(key(scene).materials || key(scene).lights);
  scene.integrator = {&integrators::directWhitted};
  EXPECT_TRUE(key(scene).materials && key(scene).lights);
  ASSERT_EQ(key(scene).bsdfs.size(), 1U);
  EXPECT_EQ(key(scene).bsdfs[0].name, "diffuse");
  scene.meshes[1].bsdf.set("albedo", scene.meshes[0].bsdf.color("albedo"));
  scene.meshes[0].normals.clear();
  scene.lights.clear();
  EXPECT_FALSE(key(scene).normals || key(scene).materials || key(scene).lights);
}

TEST(Choices, EachPartMadeGeneralChangesThatPartAlone) {
  Scene scene;
  scene.sampler.sampleCount = 1;
  scene.integrator = {&integrators::directWhitted};
  const Choices needed = chosen(scene);
  std::vector<std::string> texts;
  for (const std::string& part : generalParts()) {
    const Choices one = generalised(needed, {part});
    const TraceKey &before = needed.pictures.front().key, &after = one.pictures.front().key;
    const Uploads &was = needed.uploads, &is = one.uploads;
    EXPECT_TRUE(after != before || one.gather != needed.gather || is.indexBytes != was.indexBytes)
        << part;
    EXPECT_EQ(after.integrator, before.integrator);
    EXPECT_EQ(after.sampler, before.sampler);
    EXPECT_EQ(after.stack != before.stack, part == "stack");
    EXPECT_EQ(after.normals != before.normals, part == "normals");
    EXPECT_EQ(after.spheres != before.spheres, part == "spheres");
    EXPECT_EQ(after.hits != before.hits, part == "hits");
    EXPECT_EQ(after.jumpLevels != before.jumpLevels, part == "jump levels");
    EXPECT_EQ(after.textures != before.textures, part == "textures");
    EXPECT_EQ(one.gather != needed.gather,
              part == "apron" || part == "strips" || part == "storage texels");
  }
}

TEST(Choices, SmallTexelBuffersAreReplacedByStorageBuffers) {
  DeviceInfo small = device();
  small.limits.maxTexelBufferElements = 1U << 16;
  small.limits.maxPerStageDescriptorStorageBuffers = 30;
  Scene scene;
  scene.sampler.sampleCount = 64;
  scene.camera.width = scene.camera.height = 800;
  const Choices wide = chosen(scene), narrow = choose(scene, {}, {}, small);
  EXPECT_FALSE(wide.gather.storageTexels || key(scene).storageTexels);
  EXPECT_TRUE(narrow.gather.storageTexels && narrow.pictures.front().key.storageTexels);
  EXPECT_EQ(narrow.tiling.sampleSlots, wide.tiling.sampleSlots);
}

// Models nearly always have narrow triangles, and a first look has one sample per pixel.
TEST(Choices, CommonScenesFindTheirKernelsInTheBinary) {
  const std::vector<std::string> common = commonKernels();
  EXPECT_LE(common.size(), 20U);
  const auto embedded = [&](const std::string& text) {
    return std::find(common.begin(), common.end(), text) != common.end();
  };
  Scene scene;
  scene.integrator = {&integrators::directWhitted};
  scene.lights.resize(2);
  scene.camera.width = scene.camera.height = 768;
  scene.meshes.resize(2);
  scene.meshes[0].positions = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1e-3, 0.0}};
  for (const std::uint32_t samples : {1U, 16U, 1024U})
    for (const std::size_t triangles : {0U, 1U, 1000U}) {
      scene.sampler.sampleCount = samples;
      scene.meshes[0].triangles.assign(triangles, {0, 1, 2});
      const Choices choices = chosen(scene);
      TraceKey trace = choices.pictures.front().key;
      trace.stack = TraceKey().stack;
      EXPECT_TRUE(embedded(compose(trace))) << samples << " samples, " << triangles << " triangles";
      EXPECT_TRUE(embedded(compose(choices.gather)));
    }
}

TEST(Choices, EachChoiceHasItsReason) {
  for (const Reason& reason : chosen(Scene()).reasons) {
    EXPECT_FALSE(reason.what.empty());
    EXPECT_FALSE(reason.choice.empty()) << reason.what;
    EXPECT_FALSE(reason.why.empty()) << reason.what;
  }
}

}  // namespace
}  // namespace laver::test
