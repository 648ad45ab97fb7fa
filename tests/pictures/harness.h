#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "image/image.h"
#include "render/choices.h"
#include "render/observer.h"
#include "render/renderer.h"
#include "render/traversal.h"
#include "scene/scene.h"
#include "support/test_device.h"
#include "vulkan/device.h"

namespace laver::test {

inline VulkanOptions onTestDevice() {
  VulkanOptions options;
  options.device = testDevice();
  return options;
}

inline VulkanOptions onTestDevice(const std::string& traversal) {
  VulkanOptions options = onTestDevice();
  options.traversal = traversal;
  return options;
}

inline const DeviceInfo& testDeviceInfo() {
  static const DeviceInfo info = [] {
    const Instance instance(false);
    return deviceInfo(choosePhysicalDevice(instance, testDevice()));
  }();
  return info;
}

/// Whether the driver ends a loop after 65,535 iterations, as llvmpipe does before Mesa 25.0.
/// Unknown for other drivers.
inline std::optional<bool> loopsEndEarly() {
  const std::string& driver = testDeviceInfo().driver;
  const std::size_t mesa = driver.find("llvmpipe Mesa ");
  if (mesa == std::string::npos) return {};
  return std::stoi(driver.substr(mesa + std::string_view("llvmpipe Mesa ").size())) < 25;
}

/// The traversals that the test device supports.
inline std::vector<std::string> traversals() {
  if (runsPackets(testDeviceInfo())) return {"lane", "packet32", "packet64"};
  return {"lane"};
}

inline std::filesystem::path scenesFolder() {
  return std::filesystem::path(LAVER_SOURCE_DIR) / "scenes";
}

/// File names of the ready scenes.
inline std::vector<std::string> sceneNames() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(scenesFolder()))
    if (entry.path().extension() == ".xml") names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Names a test after its scene.
inline std::string sceneTestName(const testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param.substr(0, parameter.param.find('.'));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

inline RenderOptions allLayers() {
  RenderOptions options;
  options.layers = {&layers::normals,  &layers::depth, &layers::albedo, &layers::uv,
                    &layers::position, &layers::id,    &layers::samples};
  return options;
}

/// A scene of scenes/, `width` pixels wide with the aspect ratio of its film, with `samples` per
/// pixel.
inline Scene smallScene(const std::string& name, int width, std::uint32_t samples) {
  const std::string file = (scenesFolder() / name).string();
  const Camera full = loadScene(file).scene.camera;
  SceneOverrides overrides;
  overrides.size = glm::ivec2(width, std::max(1, width * full.height / full.width));
  overrides.sampleCount = samples;
  return loadScene(file, overrides).scene;
}

/// Ready scenes whose differences from the reference can be explained (explain.h): not those of
/// paths and lenses.
inline std::vector<std::string> explainedSceneNames() {
  std::vector<std::string> names = sceneNames();
  std::erase_if(names, [](const std::string& name) {
    const Scene scene = smallScene(name, 8, 1);
    return scene.integrator.row->bounces || scene.camera.row->lens;
  });
  return names;
}

inline Mesh quad(const std::array<glm::dvec3, 4>& corners, const glm::dvec3& albedo) {
  Mesh mesh;
  mesh.positions.assign(corners.begin(), corners.end());
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.bsdf.set("albedo", albedo);
  return mesh;
}

inline Image render(const Scene& scene, const VulkanOptions& vulkan = onTestDevice(),
                    const RenderOptions& options = {}) {
  Stats stats;
  Rendered rendered = Renderer(vulkan).render(scene, options, stats);
  EXPECT_EQ(rendered.droppedSamples, 0U) << scene.file;
  return std::move(rendered.image);
}

inline Choices choicesOf(const Scene& scene) { return choose(scene, {}, {}, testDeviceInfo()); }

/// Stops a render after some passes.
class StopAfter : public Observer {
 public:
  explicit StopAfter(int passes) : left_(passes) {}

  bool stop() override { return left_-- == 0; }
  /// Options with this observer, which must outlive them.
  RenderOptions options() { return {.observers = {this}}; }

 private:
  int left_;
};

/// Number of floats whose bits differ.
inline std::size_t differingFloats(const Image& a, const Image& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  if (a.pixels.size() != b.pixels.size()) return std::max(a.pixels.size(), b.pixels.size());
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    count += bits(a.pixels[i]) != bits(b.pixels[i]) ? 1 : 0;
  return count;
}

inline double meanOf(const Image& image) {
  double sum = 0.0;
  for (const float value : image.pixels) sum += static_cast<double>(value);
  return sum / static_cast<double>(image.pixels.size());
}

/// Share of values that differ by more than a ten-thousandth. Of paths, a sample is another one
/// where rounding decides otherwise: which side of an edge a ray passes, or whether roulette ends
/// it. Floats' directions are off by 1e-7, so that a few paths in a thousand do, after some
/// bounces; a pixel shows the samples of 25 pixels.
inline double shareBeyond(const Image& image, const Image& wanted) {
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (!(std::abs(image.pixels[i] - wanted.pixels[i]) <= 1e-4F * (1.0F + wanted.pixels[i])))
      ++beyond;
  return static_cast<double>(beyond) / static_cast<double>(image.pixels.size());
}

/// Expects the bits of `image` from every traversal.
inline void expectSameByAll(const Image& image, const Scene& scene) {
  for (const std::string& traversal : traversals())
    EXPECT_EQ(differingFloats(image, render(scene, onTestDevice(traversal))), 0U)
        << scene.file << ' ' << traversal;
}

}  // namespace laver::test
