#include "bench/laver_pass.h"

#include <cstdlib>

#include "render/renderer.h"

namespace laver::bench {

LaverRender renderWithLaver(const Scene& scene, unsigned threads, const std::string& traversal,
                            std::uint64_t samplesInFlight,
                            const std::function<void(std::size_t)>& afterPass) {
  ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  VulkanOptions vulkan;
  vulkan.device = "cpu";
  vulkan.traversal = traversal;
  vulkan.samplesInFlight = samplesInFlight;
  LaverRender out;
  double before = 0;
  RenderOptions options;
  options.progress = [&](double) {
    out.passes.push_back(out.stats.seconds.trace - before);
    before = out.stats.seconds.trace;
    if (afterPass) afterPass(out.passes.size() - 1);
  };
  out.image = Renderer(vulkan).render(scene, options, out.stats);
  return out;
}

}  // namespace laver::bench
