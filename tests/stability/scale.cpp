// Scenes whose parts differ much in size: wide grounds, stray parts, planets, far cameras. Device
// against reference, sample by sample. The naive method is what most renderers of such scenes do
// who recentre them: all coordinates are floats in the box of the whole scene.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lab/explain/explain.h"
#include "pictures/harness.h"
#include "reference/reference.h"
#include "stability/record.h"
#include "stability/scale_scenes.h"

namespace laver::test {
namespace {

using glm::dvec3;

/// volatile: g++ 12 leaves out pairs of conversions that it vectorises.
double asFloat(double x) {
  volatile const float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

/// In floats relative to the box of the whole scene.
Scene roundedInItsBox(Scene scene) {
  dvec3 lo(1e300), hi(-1e300);
  const auto add = [&](dvec3 a, dvec3 b) {
    lo = glm::min(lo, a);
    hi = glm::max(hi, b);
  };
  for (const Mesh& mesh : scene.meshes) {
    for (const dvec3& p : mesh.positions) add(p, p);
    if (mesh.sphere)
      add(mesh.sphere->centre - mesh.sphere->radius, mesh.sphere->centre + mesh.sphere->radius);
  }
  const dvec3 centre = 0.5 * (lo + hi);
  const dvec3 half = hi - centre;
  const double scale = 1.0 / std::max({half.x, half.y, half.z});
  const auto rounded = [&](dvec3 p) {
    const dvec3 inside = (p - centre) * scale;
    return dvec3(asFloat(inside.x), asFloat(inside.y), asFloat(inside.z)) / scale + centre;
  };
  for (Mesh& mesh : scene.meshes) {
    for (dvec3& p : mesh.positions) p = rounded(p);
    if (!mesh.sphere) continue;
    mesh.sphere->centre = rounded(mesh.sphere->centre);
    mesh.sphere->radius = asFloat(mesh.sphere->radius * scale) / scale;
  }
  for (int axis = 0; axis < 3; ++axis)
    for (int row = 0; row < 3; ++row)
      scene.camera.toWorld[axis][row] = asFloat(scene.camera.toWorld[axis][row]);
  scene.camera.toWorld[3] = glm::dvec4(rounded(dvec3(scene.camera.toWorld[3])), 1.0);
  return scene;
}

/// Samples that meet another primitive, or the same one farther off than 1e-4 of the distance.
double wrongHits(const Scene& scene, const Scene& truth) {
  const Reference got(scene), wanted(truth);
  double wrong = 0;
  for (int y = 0; y < truth.camera.height; ++y)
    for (int x = 0; x < truth.camera.width; ++x) {
      const glm::dvec2 film(x + 0.5, y + 0.5);
      const auto a = got.closest(film), b = wanted.closest(film);
      const bool same = a && b && a->triangle == b->triangle &&
                        std::abs(a->distance - b->distance) <= 1e-4 * b->distance;
      wrong += same || (!a && !b) ? 0 : 1;
    }
  return wrong;
}

struct Case {
  std::string name;
  Scene scene;
  bool naiveFails;
};

std::vector<Case> cases(bool full) {
  std::vector<Case> all;
  const auto add = [&](std::string name, Scene scene, bool naiveFails) {
    all.push_back({std::move(name), std::move(scene), naiveFails});
  };
  for (const double size :
       full ? std::vector{1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8} : std::vector{1e1, 1e8}) {
    const bool naive = size >= 1e6;
    add(fmt::format("level ground of half-size {:g}", size), onGround(size, size), naive);
    add(fmt::format("tilted ground of half-size {:g}", size), onGround(size, size, 0.3), naive);
    add(fmt::format("road of half-length {:g}", size), onGround(1.3, size), naive);
  }
  for (const double place : full ? std::vector{1e2, 1e5, 1e7, 1e9} : std::vector{1e9}) {
    const bool naive = place >= 1e7;
    add(fmt::format("stray triangle {:g} behind", place), withStray(place * dvec3(0.1, 0.2, 1.0)),
        naive);
    add(fmt::format("stray triangle {:g} before", place), withStray(place * dvec3(0.02, 0.1, -1.0)),
        naive);
  }
  for (const double radius : full ? std::vector{1e1, 1e3, 1e5, 6.4e6} : std::vector{6.4e6}) {
    add(fmt::format("sphere of radius {:g} below", radius), onSphere(radius), radius > 1e6);
    add(fmt::format("mesh planet of radius {:g} below", radius), onPlanet(radius), radius > 1e6);
  }
  for (const double k : full ? std::vector{1e0, 1e2, 1e4, 1e5, 1e6, 1e7} : std::vector{1e0, 1e7}) {
    add(fmt::format("mesh seen from {:g}", 7.0 * k), seenFromAfar(k, false), k >= 1e6);
    add(fmt::format("sphere seen from {:g}", 7.0 * k), seenFromAfar(k, true), k >= 1e6);
  }
  return all;
}

LAVER_STABILITY(Scale, "Scenes whose parts differ much in size") {
  for (const Case& c : cases(full)) {
    VulkanOptions vulkan;
    vulkan.device = testDevice();
    const Explanation e = explain(c.scene, c.scene, vulkan);
    std::optional<double> naive;
    if (c.naiveFails) naive = wrongHits(roundedInItsBox(c.scene), c.scene);
    // As at ordinary scale: one sample in a thousand, edges of the ball's facets among them.
    const auto wrong = e.hits.differing + e.occlusion.differing + e.unexplained();
    record.add({c.name, "renderer", e.samples, naive, static_cast<double>(wrong),
                std::max(4.0, 1e-3 * static_cast<double>(e.samples)), "samples"});
    if (e.unexplained() != 0) ADD_FAILURE() << c.name << '\n' << describe(e);
  }
}

TEST(Scale, AWideGroundAddsFewPieces) {
  // Each is a test for some rays: no more than some hundreds, whatever the size.
  for (const double size : {1e3, 1e8}) {
    const Scene scene = onGround(size, size, 0.3);
    const std::uint64_t ball = scene.meshes[0].triangles.size();
    const Packed data = pack(scene, {}, uploadsOf(scene, {}));
    EXPECT_GT(data.triangles, ball + 2);
    EXPECT_LT(data.triangles, ball + 2000);
  }
}

TEST(Scale, WhatFloatsCannotHoldIsRefused) {
  // 7e7 away, through pixels of 5e-11, something is seen from there on to 7e7 farther.
  Scene scene = seenFromAfar(1e7, false);
  Mesh behind;
  const double far = 1e8;
  behind.positions = {dvec3(-far, -far, -far), dvec3(far, -far, -far), dvec3(0.0, -far, far)};
  behind.triangles = {{0, 1, 2}};
  scene.meshes.push_back(behind);
  try {
    normalisationOf(scene);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ExitCode::Device);
    EXPECT_NE(std::string(error.what()).find("pixels"), std::string::npos);
  }
}

}  // namespace
}  // namespace laver::test
