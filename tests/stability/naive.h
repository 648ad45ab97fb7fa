#pragma once
#include <span>

#include "bvh/bvh.h"
#include "stability/twin/twin.h"

/// The usual methods, written plainly as most renderers have them: what the suite shows to fail.
namespace laver::test::naive {

/// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997, in float with
/// Nori's limits: |det| < 1e-8 is a miss. True for mint <= t <= maxt.
bool moellerTrumbore(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle,
                     float mint, float maxt, TestHit& hit);

/// Woop, Benthin and Wald's edge functions with one of two products fused, as a compiler that
/// contracts leaves them.
bool woopContracted(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);

/// Slabs by (b - o) * (1 / d) with minimum and maximum.
bool slabs(glm::vec3 origin, glm::vec3 direction, glm::vec3 lo, glm::vec3 hi);

/// Whether any triangle is met, by moellerTrumbore() or woopContracted() in our boxes, or by
/// moellerTrumbore() in slabs().
enum class Method { MoellerTrumbore, WoopContracted, Slabs };
bool meets(const Bvh& bvh, glm::vec3 origin, glm::vec3 direction, Method method);

}  // namespace laver::test::naive
