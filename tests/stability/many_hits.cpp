// Rays that meet more geometry than lavapipe lets an invocation loop through (65,535 iterations),
// and as many lights: a picture comes out, and the right one.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "pictures/harness.h"
#include "reference/reference.h"
#include "stability/record.h"

namespace laver::test {
namespace {

using glm::dvec3;

/// Seen from z = 4, lit from above.
Scene lit() {
  Scene scene;
  scene.lights = {{dvec3(0.0, 3.0, 3.0), dvec3(40.0)}};
  scene.camera.toWorld = {glm::dvec4(-1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, -1, 0),
                          glm::dvec4(0, 0, 4, 1)};
  scene.camera.fov = 40.0;
  scene.camera.width = scene.camera.height = 17;
  scene.sampler.sampleCount = 1;
  return scene;
}

/// Catches the shadows of what lies before it.
Mesh wall() {
  Mesh mesh;
  mesh.positions = {dvec3(-3, -3, -1), dvec3(3, -3, -1), dvec3(3, 3, -1), dvec3(-3, 3, -1)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// The first one red, the others blue.
Scene equalFaces(std::size_t count) {
  Scene scene = lit();
  for (const std::size_t faces : {std::size_t{1}, count - 1}) {
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {dvec3(-1, -1, 0), dvec3(1, -1, 0), dvec3(0, 1, 0)};
    mesh.triangles.assign(faces, glm::uvec3(0, 1, 2));
    mesh.bsdf.set("albedo", faces == 1 ? dvec3(0.8, 0.1, 0.1) : dvec3(0.1, 0.1, 0.8));
  }
  scene.meshes.push_back(wall());
  return scene;
}

/// A black bowl of triangles that share their middle, where rays meet the boxes of all.
Scene cap(std::size_t corners) {
  Scene scene = lit();
  Mesh& mesh = scene.meshes.emplace_back();
  mesh.bsdf.set("albedo", dvec3(0.0));
  mesh.positions.emplace_back(0.02, 0.03, 0.0);
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
    mesh.positions.emplace_back(std::cos(angle), std::sin(angle), 0.2);
  }
  for (std::size_t i = 0; i < corners; ++i)
    mesh.triangles.emplace_back(0, 1 + i, 1 + (i + 1) % corners);
  scene.meshes.push_back(wall());
  return scene;
}

/// Octahedra in one another, each open towards the camera except for its upper right face, through
/// which shadow rays leave.
Scene shells(std::size_t count) {
  Scene scene = lit();
  Mesh& mesh = scene.meshes.emplace_back();
  for (std::size_t i = 0; i < count; ++i) {
    const double r = 1.0 - 0.9 * static_cast<double>(i) / static_cast<double>(count);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const dvec3 p : {dvec3(r, 0, 0), dvec3(-r, 0, 0), dvec3(0, r, 0), dvec3(0, -r, 0),
                          dvec3(0, 0, r), dvec3(0, 0, -r)})
      mesh.positions.push_back(p);
    for (const glm::uvec3 t : {glm::uvec3(0, 2, 5), glm::uvec3(2, 1, 5), glm::uvec3(1, 3, 5),
                               glm::uvec3(3, 0, 5), glm::uvec3(0, 4, 2)})
      mesh.triangles.push_back(t + first);
  }
  return scene;
}

/// Two equal faces under lights in a spiral.
Scene manyLights(std::size_t count) {
  Scene scene = equalFaces(2);
  scene.lights.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const double at = static_cast<double>(i) / static_cast<double>(count);
    scene.lights.push_back({dvec3(0.5 * std::cos(40.0 * at), 0.5 * std::sin(40.0 * at), 1.0 + at),
                            dvec3(40.0 / static_cast<double>(count))});
  }
  return scene;
}

/// Adds the number of values that differ from the reference.
void compare(Record& record, const std::string& name, Scene scene,
             const IntegratorRow& integrator) {
  scene.integrator = {&integrator};
  const Image image = render(scene);
  const Image truth = Reference(scene).render().image;
  double differing = 0, largest = 0;
  for (const float value : truth.pixels) largest = std::max(largest, static_cast<double>(value));
  for (std::size_t i = 0; i < truth.pixels.size(); ++i)
    differing +=
        std::abs(static_cast<double>(image.pixels[i] - truth.pixels[i])) <= 1e-4 * largest ? 0 : 1;
  EXPECT_GT(largest, 0.0) << name;
  // Two pixels: a sample on an edge may see either side of it.
  record.add({fmt::format("{}, {}", name, integrator.name), "renderer", truth.pixels.size(),
              std::nullopt, differing, 6.0, "values"});
}

void compareAll(Record& record, const std::string& name, const Scene& scene) {
  for (const char* integrator : {"direct_whitted", "direct_ems", "path_mis"})
    compare(record, name, scene, *rowCalled(integratorRows(), integrator));
}

LAVER_STABILITY(CoincidentFaces, "More equal faces than a driver's loop") {
  const std::size_t count = full ? 100'000 : 70'000;
  compareAll(record, fmt::format("{} equal faces", count), equalFaces(count));
}

LAVER_STABILITY(SharedVertex, "A vertex of more triangles than a driver's loop") {
  const std::size_t count = full ? 100'000 : 70'000;
  const std::string name = fmt::format("a vertex of {} triangles", count);
  compareAll(record, name, cap(count));
  compare(record, name, cap(count), integrators::normals);
}

LAVER_STABILITY(NestedShells, "More nested shells than a driver's loop") {
  const std::size_t count = 10'000;
  compareAll(record, fmt::format("{} nested shells", count), shells(count));
}

LAVER_STABILITY(ManyLights, "More lights than a driver's loop") {
  const std::size_t count = full ? 100'000 : 3'000;
  compareAll(record, fmt::format("{} lights", count), manyLights(count));
}

}  // namespace
}  // namespace laver::test
