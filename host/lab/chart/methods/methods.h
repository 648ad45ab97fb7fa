#pragma once
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace laver::chart {

/// One intersection method: a triangle test with a box test and a node format. Its errors are free
/// of sampling noise.
struct MethodPoint {
  std::string triangles, boxes, nodes;  ///< "Moeller-Trumbore", "plain slabs", "32 bits"
  double nanoseconds = 0;               ///< per camera ray, median
  double quartiles[2] = {0, 0};
  double t99 = 0, normal99 = 0;   ///< 99th percentile of the errors: ulp of t, 2^-24 of the normal
  std::uint64_t rays = 0;         ///< aimed at edges and corners
  std::uint64_t unexplained = 0;  ///< wrong hits of these that rounding does not explain
};

/// Measures every triangle test with every box test and node format on a Vulkan device: one camera
/// ray per pixel of the scene's film, timed `runs` times, and as many rays aimed at edges and
/// corners of the triangles that these hit. Empty if `stop` returned true. Throws Error(Device).
std::vector<MethodPoint> chartMethods(const Scene& scene, const std::string& device,
                                      std::size_t runs, const std::function<bool()>& stop);

nlohmann::json toJson(const MethodPoint& m);
MethodPoint methodFromJson(const nlohmann::json& json);

}  // namespace laver::chart
