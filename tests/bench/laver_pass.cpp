#include "bench/laver_pass.h"

#include <cstdlib>

#include "render/renderer.h"

namespace laver::bench {

LaverRender renderWithLaver(const Scene& scene, unsigned threads, const std::string& traversal,
                            bool everyRay) {
  ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  VulkanOptions vulkan;
  vulkan.device = "cpu";
  vulkan.traversal = traversal;
  vulkan.wholeFilm = everyRay;
  LaverRender out;
  out.image = Renderer(vulkan).render(scene, {}, out.stats).image;
  return out;
}

}  // namespace laver::bench
