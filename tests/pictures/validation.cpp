// The Khronos validation layer finds no error in laver's use of Vulkan.
#include "pictures/harness.h"

namespace laver::test {
namespace {

VulkanOptions validated(const std::string& traversal) {
  VulkanOptions vulkan = onTestDevice(traversal);
  vulkan.validate = true;
  return vulkan;
}

class ValidatedScene : public testing::TestWithParam<std::string> {};

TEST_P(ValidatedScene, IsValidByEveryTraversalWithAndWithoutLayers) {
  const Scene scene = smallScene(GetParam(), 20, 2);
  for (const std::string& traversal : traversals()) {
    EXPECT_NO_THROW(render(scene, validated(traversal))) << traversal;
    EXPECT_NO_THROW(render(scene, validated(traversal), allLayers())) << traversal << ", layers";
  }
}
INSTANTIATE_TEST_SUITE_P(Scenes, ValidatedScene, testing::ValuesIn(sceneNames()), sceneTestName);

TEST(Validation, FindsNothingInAnEmptyScene) {
  Scene empty;
  empty.camera.width = empty.camera.height = 16;
  EXPECT_NO_THROW(render(empty, validated("lane")));
}

TEST(Validation, FindsNothingInBandsPassesAndAdaptiveSampling) {
  const Scene scene = smallScene("cornell-two-lights.xml", 40, 32);
  VulkanOptions vulkan = validated("");
  vulkan.samplesInFlight = std::uint64_t{40} * 32 * 4;
  EXPECT_NO_THROW(render(scene, vulkan));
  RenderOptions adaptive = allLayers();
  adaptive.error = 0.02;
  EXPECT_NO_THROW(render(scene, validated(""), adaptive));
}

}  // namespace
}  // namespace laver::test
