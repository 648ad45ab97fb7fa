// Each thing that kernels leave out for a scene changes no bit of its picture by itself.
#include "render/harness.h"
#include "render/specialise.h"

namespace laver::test {
namespace {

/// Scenes that differ in what they need.
std::vector<Scene> scenes() {
  std::vector<Scene> all;
  // Vertex normals and albedos at once, a tent.
  all.push_back(smallScene("curved-normals.xml", 35, 2));
  all[0].integrator = Integrator::DirectWhitted;
  all[0].meshes[0].bsdf.albedo = glm::dvec3(0.1, 0.5, 0.9);
  // Neither; no light; a box.
  all.push_back(smallScene("cornell-two-lights.xml", 35, 1));
  all[1].lights.clear();
  all[1].filter.kind = Filter::Kind::Box;
  all[1].filter.radius = 0.5;
  // 34 triangles; Mitchell.
  all.push_back(smallScene("cornell-two-lights.xml", 35, 2));
  // One albedo; a gaussian.
  all.push_back(all[2]);
  all[3].filter = {};
  for (Mesh& mesh : all[3].meshes) mesh.bsdf.albedo = all[2].meshes[0].bsdf.albedo;
  return all;
}

struct Saving {
  const char* name;
  std::uint32_t constant;
};

void PrintTo(const Saving& saving, std::ostream* out) { *out << saving.name; }

class Savings : public testing::TestWithParam<Saving> {};

TEST_P(Savings, KeepTheBits) {
  const std::uint32_t one = 1U << GetParam().constant;
  bool saved = false;
  for (const Scene& scene : scenes()) {
    const SpecConstants constants = specialise(scene, {});
    if (generalise(constants, one) == constants) continue;
    // One scene by both traversals.
    for (const char* traversal : {"packet", "lane"}) {
      if (saved && traversal == std::string("lane")) continue;
      VulkanOptions vulkan = cpuDevice();
      vulkan.traversal = traversal;
      const Image needed = render(scene, vulkan);
      vulkan.generic = one;
      EXPECT_EQ(differingFloats(needed, render(scene, vulkan)), 0U)
          << scene.file << ' ' << traversal;
    }
    saved = true;
  }
  EXPECT_TRUE(saved);
}

INSTANTIATE_TEST_SUITE_P(
    Each, Savings,
    testing::Values(Saving{"Stack", shared::SPEC_STACK}, Saving{"Normals", shared::SPEC_NORMALS},
                    Saving{"Albedos", shared::SPEC_ALBEDOS}, Saving{"Lights", shared::SPEC_LIGHTS},
                    Saving{"JumpLevels", shared::SPEC_JUMP_LEVELS},
                    Saving{"Filter", shared::SPEC_FILTER}, Saving{"Apron", shared::SPEC_APRON},
                    Saving{"Hits", shared::SPEC_HITS}, Saving{"DarkSides", shared::SPEC_DARK_SIDES},
                    Saving{"IndexBytes", shared::SPEC_INDEX_BYTES}),
    [](const auto& instance) { return instance.param.name; });

TEST(WithoutALight, NoTreeIsUploadedAndThePictureIsBlack) {
  Scene scene = smallScene("cornell-two-lights.xml", 16, 1);
  scene.lights.clear();
  Stats stats;
  const Image image = Renderer(cpuDevice()).render(scene, {}, stats);
  EXPECT_EQ(stats.triangles, 0U);
  EXPECT_EQ(stats.attributeBytes, 0U);
  for (const float value : image.pixels) EXPECT_EQ(value, 0.0F);
}

}  // namespace
}  // namespace laver::test
