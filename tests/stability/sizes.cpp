// Scaled scenes give the same picture as at scale 1, and the same bits if the scale is a power of
// two (PowersOfTwo).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pictures/harness.h"
#include "stability/naive.h"
#include "stability/record.h"
#include "stability/scaled.h"
#include "stability/subject.h"
#include "stability/surfaces.h"

namespace laver::test {
namespace {

VulkanOptions by(const std::string& traversal) {
  VulkanOptions vulkan;
  vulkan.device = testDevice();
  vulkan.traversal = traversal;
  return vulkan;
}

LAVER_STABILITY(PowersOfTwo, "The scene scaled by 2^k: the same bits") {
  for (const char* name : {"bunny-whitted.xml", "cornell-two-lights.xml", "bunny-depth.xml"})
    for (const std::string traversal : {"lane", "packet32", "packet64"}) {
      const Scene scene = smallScene(name, 96, 2);
      const VulkanOptions vulkan = by(traversal);
      const Image original = render(scene, vulkan);
      std::uint64_t floats = 0, naive = 0, differ = 0;
      for (int k = -20; k <= 20; k += full ? 1 : 8) {
        if (k == 0) continue;
        const double factor = std::ldexp(1.0, k);
        Image image = render(scaled(scene, factor), vulkan);
        undoScale(scene, factor, image);
        floats += image.pixels.size();
        differ += differingFloats(original, image);
        // Nori's constants, mint 1e-4 and |det| < 1e-8, do not scale: at 2^-20 its triangles of
        // 0.01 have determinants of 1e-16.
        naive += naiveLost(scene, factor);
      }
      record.add({name, traversal, floats, static_cast<double>(naive), static_cast<double>(differ),
                  0.0, "floats"});
    }
}

LAVER_STABILITY(Sizes, "Scenes of size 1e-15 to 1e15") {
  for (const char* name : {"bunny-whitted.xml", "cornell-two-lights.xml"})
    for (const std::string traversal : {"lane", "packet32", "packet64"}) {
      const Scene scene = smallScene(name, 96, 1);
      const VulkanOptions vulkan = by(traversal);
      const Image original = render(scene, vulkan);
      std::uint64_t pixels = 0, naive = 0, wrong = 0;
      for (const double size : {1e-15, 1e-9, 1e-3, 1e3, 1e9, 1e15}) {
        Image image = render(scaled(scene, size), vulkan);
        undoScale(scene, size, image);
        pixels += image.pixels.size() / 3;
        naive += naiveLost(scene, size);
        // Vertices are rounded again and move by an ulp: one pixel in 1,000, at edges, may change.
        std::uint64_t off = 0;
        for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
          const float d = std::abs(image.pixels[i] - original.pixels[i]);
          off += d <= 1e-4F * std::max(1.0F, original.pixels[i]) ? 0 : 1;
        }
        if (off > image.pixels.size() / 3000) wrong += off;
      }
      record.add({name, traversal, pixels, static_cast<double>(naive), static_cast<double>(wrong),
                  0.0, "pixels"});
    }
}

}  // namespace
}  // namespace laver::test
