#include "bench/laver_pass.h"

#include <cstdlib>

#include "render/renderer.h"

namespace laver::bench {

Stats renderWithLaver(const Scene& scene, unsigned threads, const std::string& traversal,
                      bool allPixels) {
  ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  VulkanOptions vulkan;
  vulkan.device = "cpu";
  vulkan.traversal = traversal;
  vulkan.wholeFilm = allPixels;
  Stats stats;
  Renderer(vulkan).render(scene, {}, stats);
  return stats;
}

}  // namespace laver::bench
