// Each part that kernels leave out for a scene changes no bit of its picture.
#include <algorithm>
#include <tuple>
#include <utility>

#include "pictures/harness.h"
#include "render/choices.h"

namespace laver::test {
namespace {

/// Scenes with different needs.
std::vector<Scene> scenes() {
  std::vector<Scene> all;
  // Vertex normals and albedos, tent filter, stratified sampler.
  all.push_back(smallScene("curved-normals.xml", 35, 2));
  all[0].integrator = {&integrators::directWhitted};
  all[0].sampler.row = &samplers::stratified;
  all[0].meshes[0].bsdf.set("albedo", glm::dvec3(0.1, 0.5, 0.9));
  // Neither normals nor light; box filter.
  all.push_back(smallScene("cornell-two-lights.xml", 35, 1));
  all[1].lights.clear();
  all[1].filter.row = &filters::box;
  all[1].filter.radius = 0.5;
  // 34 triangles; Mitchell filter, Sobol sampler.
  all.push_back(smallScene("cornell-two-lights.xml", 35, 2));
  all[2].sampler.row = &samplers::sobol;
  // One albedo; Gaussian filter, independent sampler.
  all.push_back(all[2]);
  all[3].filter = {};
  all[3].sampler.row = &samplers::independent;
  for (Mesh& mesh : all[3].meshes) mesh.bsdf.set("albedo", all[2].meshes[0].bsdf.color("albedo"));
  // A checker and a background of one radiance: no image.
  all.push_back(all[3]);
  all[4].meshes[1].bsdf.show("albedo", Texture());
  all[4].environment = Environment();
  return all;
}

class General : public testing::TestWithParam<std::string> {};

TEST_P(General, AnUnusedPartChangesNoBit) {
  const std::string& part = GetParam();
  bool changed = false;
  for (const Scene& scene : scenes()) {
    const Choices needed = choicesOf(scene);
    const Choices general = generalised(needed, {part});
    if (general.pictures.front().key == needed.pictures.front().key &&
        general.gather == needed.gather && general.uploads.indexBytes == needed.uploads.indexBytes)
      continue;
    // Only one scene by all traversals.
    for (const std::string& traversal : traversals()) {
      if (changed && traversal != std::string("packet32")) continue;
      VulkanOptions vulkan = onTestDevice(traversal);
      const Image image = render(scene, vulkan);
      vulkan.general = {part};
      EXPECT_EQ(differingFloats(image, render(scene, vulkan)), 0U)
          << scene.file << ' ' << traversal;
    }
    changed = true;
  }
  // A device without packets has no strips to leave out.
  EXPECT_TRUE(changed || (part == "strips" && !runsPackets(testDeviceInfo())));
}

INSTANTIATE_TEST_SUITE_P(Parts, General, testing::ValuesIn(generalParts()),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

/// The fields of a key that some part makes general. The others say what is shown, how rays are
/// traced (traversal, portions, lockstep, bounces, adaptive: tests of their own), name the BSDFs or
/// are the user's text; what meshes emit concerns integrators that follow paths alone. A new field
/// does not compile here before it has one of the two places.
auto madeGeneral(const TraceKey& key) {
  const auto& [integrator, userFile, userText, camera, sampler, background, bsdfs, textures, layout,
               traversal, stack, jumpLevels, hits, normals, materials, bsdfRecords, spheres, caps,
               farParts, slivers, farCamera, portions, lights, shapedLights, manyLights, lockstep,
               bounces, emission, texturedLights, byteImages, floatImages, adaptive, signedValues,
               storageTexels, properties] = key;
  return std::tuple(background, textures, layout, stack, jumpLevels, hits, normals, materials,
                    bsdfRecords, spheres, caps, farParts, slivers, farCamera, lights, shapedLights,
                    manyLights, byteImages, floatImages, storageTexels);
}

/// The same; of the filter's texts each rounds in its own way.
auto madeGeneral(const GatherKey& key) {
  const auto& [filter, apron, strips, adaptive, storageTexels] = key;
  return std::tuple(apron, strips, storageTexels);
}

/// Notes which elements differ.
template <class Tuple, std::size_t... I>
void noteDifferent(const Tuple& a, const Tuple& b, std::vector<bool>& differ,
                   std::index_sequence<I...> /*all*/) {
  differ.resize(sizeof...(I));
  ((differ[I] = differ[I] || std::get<I>(a) != std::get<I>(b)), ...);
}

template <class Tuple>
void noteDifferent(const Tuple& a, const Tuple& b, std::vector<bool>& differ) {
  noteDifferent(a, b, differ, std::make_index_sequence<std::tuple_size_v<Tuple>>());
}

TEST(GeneralParts, ReachEveryFieldOfTheKeysThatAScenesNeedsDecide) {
  std::vector<bool> trace, gather;
  for (const Scene& scene : scenes()) {
    Choices needed = choicesOf(scene);
    needed.gather.strips = true;  // as on a device that runs packets
    const Choices general = generalised(needed, generalParts());
    noteDifferent(madeGeneral(needed.pictures.front().key),
                  madeGeneral(general.pictures.front().key), trace);
    noteDifferent(madeGeneral(needed.gather), madeGeneral(general.gather), gather);
  }
  EXPECT_EQ(trace, std::vector<bool>(trace.size(), true));
  EXPECT_EQ(gather, std::vector<bool>(gather.size(), true));
}

TEST(WithoutALight, NoTreeIsUploadedAndThePictureIsBlack) {
  Scene scene = smallScene("cornell-two-lights.xml", 16, 1);
  scene.lights.clear();
  Stats stats;
  const Image image = Renderer(onTestDevice()).render(scene, {}, stats).image;
  EXPECT_EQ(stats.triangles, 0U);
  EXPECT_EQ(stats.attributeBytes, 0U);
  for (const float value : image.pixels) EXPECT_EQ(value, 0.0F);
}

TEST(WithoutALight, ABackgroundIsSeenAroundTheMeshes) {
  Scene scene = smallScene("cornell-two-lights.xml", 32, 1);
  scene.lights.clear();
  scene.filter = {};        // no weight is negative
  scene.camera.fov = 90.0;  // the box is 9 pixels wide
  scene.environment = Environment();
  const Image image = render(scene);
  const auto ends = std::minmax_element(image.pixels.begin(), image.pixels.end());
  EXPECT_EQ(*ends.first, 0.0F);
  EXPECT_NEAR(*ends.second, 1.0F, 1e-6F);  // quotient of sums
}

TEST(WithoutALight, LayersEqualTheirIntegratorsAlone) {
  // The main picture reads nothing; one layer reads normals, another materials and textures.
  Scene scene = smallScene("curved-normals.xml", 16, 2);
  scene.integrator = {&integrators::directWhitted};
  scene.lights.clear();
  scene.meshes.push_back(scene.meshes[0]);
  for (glm::dvec3& p : scene.meshes[1].positions) p += glm::dvec3(0.3, 0.0, 0.3);
  scene.meshes[1].bsdf.set("albedo", glm::dvec3(0.1, 0.5, 0.9));
  for (const bool textured : {false, true}) {
    if (textured) scene.meshes[1].bsdf.show("albedo", Texture());
    RenderOptions options;
    options.layers = {&layers::normals, &layers::albedo, &layers::id};
    const Image all = render(scene, onTestDevice(), options);
    std::size_t first = 3;
    for (const LayerRow* layer : options.layers) {
      RenderOptions one;
      one.layers = {layer};
      const Image single = render(scene, onTestDevice(), one);
      float largest = 0.0F;
      for (int y = 0; y < all.height; ++y)
        for (int x = 0; x < all.width; ++x)
          for (std::size_t c = 3; c < single.channels.size(); ++c) {
            EXPECT_EQ(all.at(x, y, first + c - 3), single.at(x, y, c)) << single.channels[c];
            largest = std::max(largest, single.at(x, y, c));
          }
      EXPECT_GT(largest, 0.0F) << single.channels.back();
      first += single.channels.size() - 3;
    }
  }
}

}  // namespace
}  // namespace laver::test
