#pragma once
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/error.h"
#include "image/image.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace laver::test {

/// The device of all tests: by type, whatever its driver is called.
inline VulkanOptions cpuDevice() {
  VulkanOptions options;
  options.device = "cpu";
  return options;
}

/// What traces on the test device: subgroups of 8 lanes can do all.
inline constexpr std::array kTraversals{"lane", "packet32", "packet64"};

inline VulkanOptions cpuDevice(const std::string& traversal) {
  VulkanOptions options = cpuDevice();
  options.traversal = traversal;
  return options;
}

inline std::filesystem::path scenesFolder() {
  return std::filesystem::path(LAVER_SOURCE_DIR) / "scenes";
}

/// A scene of scenes/, `width` pixels wide with its film's proportions, `samples` a pixel.
inline Scene smallScene(const std::string& name, int width, std::uint32_t samples) {
  const std::string file = (scenesFolder() / name).string();
  const Camera full = loadScene(file).scene.camera;
  SceneOverrides overrides;
  overrides.size = glm::ivec2(width, std::max(1, width * full.height / full.width));
  overrides.sampleCount = samples;
  return loadScene(file, overrides).scene;
}

inline Image render(const Scene& scene, const VulkanOptions& vulkan = cpuDevice(),
                    const RenderOptions& options = {}) {
  Stats stats;
  Image image = Renderer(vulkan).render(scene, options, stats);
  EXPECT_EQ(stats.droppedSamples, 0U) << scene.file;
  return image;
}

/// Pixels whose bits differ.
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

/// All traversals give `image`'s bits.
inline void expectSameByAll(const Image& image, const Scene& scene) {
  for (const char* traversal : kTraversals)
    EXPECT_EQ(differingFloats(image, render(scene, cpuDevice(traversal))), 0U)
        << scene.file << ' ' << traversal;
}

}  // namespace laver::test
