#include "reference/world.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/openness.h"

namespace laver::reference {

namespace {

Box boxOf(const Scene& scene) {
  Box box;
  for (const Mesh& mesh : scene.meshes) {
    for (const glm::dvec3& position : mesh.positions) box.add(position);
    if (mesh.sphere) {
      box.add(mesh.sphere->centre - mesh.sphere->radius);
      box.add(mesh.sphere->centre + mesh.sphere->radius);
    }
  }
  return box.lo.x <= box.hi.x ? box : Box{glm::dvec3(0.0), glm::dvec3(0.0)};
}

/// The box's own centre if the camera is nowhere.
glm::dvec3 nearestToCamera(const Box& box, const Camera& camera) {
  const glm::dvec4 origin = camera.toWorld[3];
  const glm::dvec3 eye = glm::dvec3(origin) / origin.w;
  if (!std::isfinite(eye.x + eye.y + eye.z)) return 0.5 * box.lo + 0.5 * box.hi;
  return glm::clamp(eye, box.lo, box.hi);
}

glm::dvec3 unit(const LongVec& vector) {
  return glm::dvec3(vector / std::sqrt(glm::dot(vector, vector)));
}

bool finite(const LongVec& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The gradient's direction: where u grows and v does not. Texture coordinates on a line have none;
/// 2^-20 is their own rounding in files of six digits.
glm::dvec3 alongU(const Mesh& mesh, const glm::uvec3& t) {
  const glm::dvec3 e1 = mesh.positions[t.y] - mesh.positions[t.x];
  const glm::dvec3 e2 = mesh.positions[t.z] - mesh.positions[t.x];
  if (mesh.uvs.empty()) return e1;
  const glm::dmat2 uv(mesh.uvs[t.y] - mesh.uvs[t.x], mesh.uvs[t.z] - mesh.uvs[t.x]);
  const double determinant = glm::determinant(uv);
  if (std::abs(determinant) <=
      0x1p-20 * (std::abs(uv[0].x * uv[1].y) + std::abs(uv[0].y * uv[1].x)))
    return glm::dvec3(0.0);
  return (uv[1].y * e1 - uv[0].y * e2) / determinant;
}

}  // namespace

World::World(const Scene& scene, unsigned threads)
    : scene_(&scene),
      box_(boxOf(scene)),
      centre_(nearestToCamera(box_, scene.camera)),
      lights_(scene.lights),
      tree_(gather(), threads, originals()) {
  for (PointLight& light : lights_) light.position -= centre();
  std::uint64_t count = 0;
  for (const Mesh& mesh : scene.meshes) {
    first_.push_back(count);
    if (mesh.sphere)
      spheres_.push_back({mesh.sphere->centre - centre(), mesh.sphere->radius,
                          static_cast<std::uint32_t>(count), first_.size() - 1});
    count += mesh.primitives();
  }
}

std::vector<Triangle> World::gather() const {
  std::vector<Triangle> triangles;
  std::uint32_t number = 0;
  const glm::dvec3 centre = this->centre();
  for (const Mesh& mesh : scene_->meshes) {
    if (mesh.sphere) ++number;
    for (const glm::uvec3& t : mesh.triangles) {
      triangles.emplace_back(mesh.positions[t.x] - centre, mesh.positions[t.y] - centre,
                             mesh.positions[t.z] - centre, number++);
    }
  }
  return triangles;
}

/// first_ is there once rays are traced.
Originals World::originals() const {
  return {[this](std::uint32_t id) {
            const std::size_t index = meshOf(id);
            const Mesh& mesh = scene_->meshes[index];
            const glm::uvec3& t = mesh.triangles[id - first_[index]];
            return Corners{mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]};
          },
          centre()};
}

std::size_t World::meshOf(std::uint32_t id) const {
  const auto next = std::upper_bound(first_.begin(), first_.end(), id);
  return static_cast<std::size_t>(next - first_.begin()) - 1;
}

std::optional<WorldHit> World::closest(const Ray& ray, double tmin, double tmax) const {
  return nearest(tree_.closest(ray, tmin, tmax), ray, tmin, tmax);
}

std::optional<WorldHit> World::closestAhead(const Ray& ray) const {
  return nearest(tree_.closestAhead(ray), ray, 0.0, std::numeric_limits<double>::infinity());
}

std::optional<WorldHit> World::nearest(const std::optional<TreeHit>& triangle, const Ray& ray,
                                       double tmin, double tmax) const {
  std::optional<WorldHit> best;
  if (triangle) best = WorldHit{triangle->t, triangle};
  for (const WorldSphere& sphere : spheres_) {
    const auto hit = reference::closest(sphere, ray, tmin, tmax);
    if (!hit || (best && (hit->t > best->t || (hit->t == best->t && sphere.id > best->id()))))
      continue;
    best = WorldHit{hit->t, {}, &sphere, hit->normal};
  }
  return best;
}

bool World::blocked(const glm::dvec3& from, const glm::dvec3& to) const {
  return tree_.blocked(from, to) ||
         std::any_of(spheres_.begin(), spheres_.end(),
                     [&](const WorldSphere& sphere) { return crosses(sphere, from, to); });
}

Surface World::surface(const WorldHit& hit) const {
  if (hit.triangle) return surface(*hit.triangle);
  const WorldSphere& sphere = *hit.sphere;
  Surface surface{};
  surface.position = sphere.centre + sphere.radius * hit.normal;
  surface.geometric = surface.shading = hit.normal;
  surface.uv = uvOf(hit.normal);
  surface.mesh = &scene_->meshes[sphere.mesh];
  surface.textureUv = surface.uv;
  surface.tangent = glm::cross(glm::cross(hit.normal, glm::dvec3(0.0, 0.0, -1.0)), hit.normal);
  // As below: half an ulp per term and component, and again for the offset position.
  surface.offset =
      8 * 0x1p-53 * glm::dot(glm::abs(surface.geometric), glm::abs(sphere.centre) + sphere.radius);
  return surface;
}

Surface World::surfaceOn(std::uint32_t id, glm::dvec2 numbers) const {
  const auto sphere =
      std::lower_bound(spheres_.begin(), spheres_.end(), id,
                       [](const WorldSphere& s, std::uint32_t wanted) { return s.id < wanted; });
  if (sphere != spheres_.end() && sphere->id == id)
    return surface(WorldHit{0.0, {}, &*sphere, onSphere(numbers)});
  const std::size_t index = meshOf(id);
  const Mesh& mesh = scene_->meshes[index];
  const glm::uvec3& t = mesh.triangles[id - first_[index]];
  const Triangle triangle(mesh.positions[t.x] - centre(), mesh.positions[t.y] - centre(),
                          mesh.positions[t.z] - centre(), id);
  const double root = std::sqrt(numbers.x);
  return surface(TreeHit{&triangle, 0.0, {1.0 - root, root - numbers.y * root, numbers.y * root}});
}

Surface World::surface(const TreeHit& hit) const {
  const Triangle& triangle = *hit.triangle;
  const std::size_t index = meshOf(triangle.id);
  const Mesh& mesh = scene_->meshes[index];
  const glm::uvec3& indices = mesh.triangles[triangle.id - first_[index]];

  LongVec position(0.0L);
  glm::dvec3 size(0.0);  // largest |coordinate| of the corners
  for (std::size_t i = 0; i < 3; ++i) {
    position += static_cast<long double>(hit.weights[i]) * LongVec(triangle.corner[i]);
    size = glm::max(size, glm::abs(triangle.corner[i]));
  }

  // Odd permutations of the corners reverse the winding.
  const bool reversed = (triangle.place[1] + 3 - triangle.place[0]) % 3 == 2;
  Surface surface{};
  surface.position = glm::dvec3(position);
  surface.geometric = unit(reversed ? -triangle.normal() : triangle.normal());
  surface.shading = surface.geometric;
  const Weights given = triangle.asGiven(hit.weights);
  glm::dvec2 uv(given[1], given[2]);
  if (!mesh.uvs.empty()) {
    uv = glm::dvec2(0.0);
    for (int i = 0; i < 3; ++i) uv += given[static_cast<std::size_t>(i)] * mesh.uvs[indices[i]];
  }
  surface.textureUv = uv;
  surface.tangent = alongU(mesh, indices);
  surface.mesh = &mesh;
  // Bound of the distance between position and plane: half an ulp per component, and again for the
  // offset position, is below 2 * 2^-53 * sum |n_i| size_i; 8 covers neighbours whose corners were
  // rounded off a common plane.
  surface.offset = 8 * 0x1p-53 * glm::dot(glm::abs(surface.geometric), size);

  if (!mesh.normals.empty()) {
    const Weights weights = triangle.asGiven(hit.weights);
    LongVec sum(0.0L);
    for (int i = 0; i < 3; ++i) {
      sum += static_cast<long double>(weights[static_cast<std::size_t>(i)]) *
             LongVec(mesh.normals[indices[i]]);
    }
    if (finite(sum) && glm::dot(sum, sum) > 0.0L) surface.shading = unit(sum);
  }
  if (!mesh.uvs.empty()) {
    const Weights weights = triangle.asGiven(hit.weights);
    for (int i = 0; i < 3; ++i)
      surface.uv += weights[static_cast<std::size_t>(i)] * mesh.uvs[indices[i]];
  }
  return surface;
}

}  // namespace laver::reference
