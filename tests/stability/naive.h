#pragma once
#include <span>

#include "bvh/bvh.h"
#include "stability/twin/twin.h"

/// The common methods, as most renderers implement them. The suite shows that they fail.
namespace laver::test::naive {

/// Moeller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997, in float with
/// Nori's limits: |det| < 1e-8 is a miss. True for mint <= t <= maxt.
bool moellerTrumbore(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle,
                     float mint, float maxt, TestHit& hit);

/// Woop, Benthin and Wald's edge functions with one of the two products fused, as a contracting
/// compiler generates them.
bool woopContracted(glm::vec3 origin, glm::vec3 direction, const shared::Triangle& triangle);

/// The slab test as (b - o) * (1 / d) with min and max.
bool slabs(glm::vec3 origin, glm::vec3 direction, glm::vec3 lo, glm::vec3 hi);

/// Whether any triangle is hit, by moellerTrumbore() or woopContracted() with laver's boxes, or by
/// moellerTrumbore() with slabs().
enum class Method { MoellerTrumbore, WoopContracted, Slabs };
bool intersects(const Bvh& bvh, glm::vec3 origin, glm::vec3 direction, Method method);

}  // namespace laver::test::naive
