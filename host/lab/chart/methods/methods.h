#pragma once
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace laver::chart {

/// Panel C: one way to meet triangles through a tree, without any noise.
struct MethodPoint {
  std::string triangles, boxes, nodes;  ///< "Moeller-Trumbore", "plain slabs", "32 bits"
  double nanoseconds = 0;               ///< a camera ray, median
  double quartiles[2] = {0, 0};
  double t99 = 0, normal99 = 0;  ///< 99th percentile of the errors: ulp of t, 2^-24 of the normal
  std::uint64_t rays = 0,
                unexplained = 0;  ///< aimed at edges and corners: other answers than exact
};

/// Every triangle test with every box test and form of nodes, on a Vulkan device: a camera ray for
/// each pixel of the scene's film, timed `runs` times, and as many rays aimed at an edge or a
/// corner of what these meet. None where `stop` ended it. Throws Error(Device).
std::vector<MethodPoint> chartMethods(const Scene& scene, const std::string& device,
                                      std::size_t runs, const std::function<bool()>& stop);

nlohmann::json toJson(const MethodPoint& m);
MethodPoint methodFromJson(const nlohmann::json& json);

}  // namespace laver::chart
