// Rays from inside closed meshes, aimed at edges and vertices. Each of them must hit the mesh.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/parallel.h"
#include "stability/meshes.h"
#include "stability/naive.h"
#include "stability/record.h"
#include "stability/subject.h"

namespace laver::test {
namespace {

constexpr std::uint64_t kBatch = 4096;     // rays of one generator
constexpr std::uint64_t kChunk = 1 << 18;  // rays that all subjects trace

/// Rays from points inside a sphere of `radius`, 64 from each, half of them aimed at vertices.
std::vector<TestRay> aimedRays(const ClosedMesh& mesh, glm::dvec3 centre, double radius,
                               std::uint64_t chunk) {
  std::vector<TestRay> rays(kChunk);
  forBatches(kChunk, kBatch, chunk, [&](std::uint64_t first, std::mt19937& random) {
    std::uniform_real_distribution<double> inside(-0.17 * radius, 0.17 * radius);
    glm::vec3 origin;
    for (std::uint64_t i = 0; i < kBatch; ++i) {
      if (i % 64 == 0) origin = centre + glm::dvec3(inside(random), inside(random), inside(random));
      rays[first + i] = rayOf(origin, aimedRay(mesh, origin, i % 2 == 0, random));
    }
  });
  return rays;
}

std::uint64_t missesOf(const Bvh& bvh, naive::Method method, const std::vector<TestRay>& rays) {
  std::atomic<std::uint64_t> count = 0;
  parallelFor(rays.size(), kBatch, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      count += naive::intersects(bvh, rays[i].origin, rays[i].direction, method) ? 0 : 1;
  });
  return count;
}

/// Each dot is a ray: white if it hit, black if it was lost.
void addPicture(Record& record, const ClosedMesh& mesh, const Bvh& listed, Subject& subject) {
  constexpr int kSide = 96;
  Bitmap before(kSide, kSide, {}), after(kSide, kSide, {});
  auto rays = aimedRays(mesh, glm::dvec3(0.0), 1.0, 99);
  rays.resize(before.pixels.size());
  const auto hits = subject.closest(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (naive::intersects(listed, rays[i].origin, rays[i].direction,
                          naive::Method::MoellerTrumbore))
      before.pixels[i] = {255, 255, 255};
    if (hits[i].id != shared::NO_HIT) after.pixels[i] = {255, 255, 255};
  }
  record.picture(
      "Holes: each dot is a ray aimed at an edge or a vertex of a closed mesh from inside; black "
      "ones went through it.",
      before, after);
}

LAVER_STABILITY(Edges, "Edge and vertex rays at closed meshes") {
  // The whole is 1e8 rays, shared among the offsets and the traversals that run on a device.
  const std::uint64_t chunks = amount(full, 1, 64);
  for (const double offset : {0.0, 1e3, 1e5}) {
    // At 1e5 floats are 2^-7 apart: a sphere of radius 10 keeps its 82,000 triangles apart.
    const double radius = offset > 1e4 ? 10.0 : 1.0;
    const glm::dvec3 centre = offset * glm::dvec3(1.0, 0.7, -0.4);
    const ClosedMesh mesh = closedBumpySphere(radius, centre);
    const Bvh listed = inListedOrder(mesh);
    const auto all = subjects(mesh.bvh);
    std::vector<std::uint64_t> traced(all.size()), misses(all.size());
    std::uint64_t naiveRays = 0, moeller = 0, woop = 0;
    for (std::uint64_t chunk = 0; chunk < chunks; ++chunk) {
      const auto rays = aimedRays(mesh, centre, radius, chunk);
      if (chunk < 4) {
        naiveRays += kChunk;
        moeller += missesOf(listed, naive::Method::MoellerTrumbore, rays);
        woop += missesOf(listed, naive::Method::WoopContracted, rays);
      }
      for (std::size_t s = 0; s < all.size(); ++s) {
        std::span part(rays);
        if (all[s]->slow) part = part.first(kChunk / 8);
        const auto hits = all[s]->closest(part);
        traced[s] += hits.size();
        misses[s] += static_cast<std::uint64_t>(std::count_if(
            hits.begin(), hits.end(), [](const auto& h) { return h.id == shared::NO_HIT; }));
      }
    }
    const std::string name = "offset " + std::to_string(static_cast<int>(offset));
    for (std::size_t s = 0; s < all.size(); ++s) {
      const bool contracted = all[s]->name == "C++ contracted";
      const double share =
          static_cast<double>(contracted ? woop : moeller) / static_cast<double>(naiveRays);
      record.add({name + (contracted ? ", naive: Woop contracted" : ""), all[s]->name, traced[s],
                  std::round(share * static_cast<double>(traced[s])),
                  static_cast<double>(misses[s]), 0.0, "misses", all[s]->seconds});
    }
    if (offset == 0.0) addPicture(record, mesh, listed, *all[0]);
  }
}

}  // namespace
}  // namespace laver::test
