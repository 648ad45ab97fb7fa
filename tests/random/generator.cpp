#include "random/generator.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "random/lighting.h"
#include "random/parts.h"
#include "random/viewpoint.h"
#include "scene/texture_forms.h"
#include "scene/transform.h"

namespace laver::test {
namespace {

using glm::dvec3;

/// Meshes are made in a space in which most are of unit size around the origin.
Mesh meshOf(const Part& part, const glm::dmat4& toWorld) {
  return obj::toWorld(part.data, toWorld).value_or(Mesh{});
}

glm::dmat4 placed(dvec3 at, double size, const glm::dmat4& turn) {
  glm::dmat4 result(size);
  result[3] = glm::dvec4(at, 1.0);
  return result * turn;
}

Mesh sphereMesh(dvec3 centre, double radius) {
  Mesh mesh;
  mesh.sphere = Sphere{centre, radius};
  return mesh;
}

Mesh randomTriangles(bool contested, Draw& draw, std::string& traits) {
  Part part = randomPart(draw, contested);
  std::string name = part.name;
  if (draw.chance(0.3)) name += ", " + addNormals(part.data, draw);
  const double size = draw.chance(0.3) ? draw.scale(1e-4, 1.0) : draw.between(0.3, 1.0);
  const glm::dmat4 turn = randomTransform(draw, name);
  traits += fmt::format("; {} of size {:.2g}", name, size);
  return meshOf(part, placed(0.8 * draw.point(), size, turn));
}

/// Of the last sphere: around it, inside, or touching from either side.
Mesh besideSphere(const Sphere& last, Draw& draw, std::string& traits) {
  const double radius = last.radius * draw.scale(1e-3, 10.0);
  switch (draw.below(3)) {
    case 0:
      traits += "; nested sphere";
      return sphereMesh(last.centre, radius);
    case 1:
      traits += "; sphere touching from outside";
      return sphereMesh(last.centre + (last.radius + radius) * draw.direction(), radius);
    default:
      traits += "; sphere touching from inside";
      return sphereMesh(last.centre + (last.radius - radius) * draw.direction(), radius);
  }
}

Mesh randomSphere(const std::vector<Mesh>& meshes, Draw& draw, std::string& traits) {
  for (const Mesh& mesh : meshes)
    if (mesh.sphere && draw.chance(0.5)) return besideSphere(*mesh.sphere, draw, traits);
  const double radius = draw.chance(0.3) ? draw.scale(1e-4, 1.0) : draw.between(0.1, 0.7);
  traits += fmt::format("; sphere of radius {:.2g}", radius);
  return sphereMesh(0.8 * draw.point(), radius);
}

/// The same mesh again, or moved by its own extent, so that faces of a box coincide.
Mesh copied(const Mesh& from, bool contested, Draw& draw, std::string& traits) {
  Mesh mesh = from;
  if (!contested || draw.chance(0.5) || mesh.sphere || mesh.positions.empty()) {
    traits += "; the same again";
    return mesh;
  }
  const glm::uvec3 t = mesh.triangles.empty() ? glm::uvec3(0) : mesh.triangles.front();
  const dvec3 edge = mesh.positions[t.y] - mesh.positions[t.x];
  for (dvec3& p : mesh.positions) p += edge;
  traits += "; its copy beside it";
  return mesh;
}

/// Much larger than the rest, or far from it.
Mesh largePart(Draw& draw, std::string& traits) {
  const double size = draw.scale(10.0, 1e6);
  switch (draw.below(3)) {
    case 0: {
      traits += fmt::format("; ground of half-size {:.2g}", size);
      Part part{"ground", {}};
      const double tilt = draw.chance(0.5) ? 0.0 : draw.between(0.0, 1.0);
      for (const auto& [u, v] :
           {std::pair(-1, -1), std::pair(-1, 1), std::pair(1, 1), std::pair(1, -1)})
        part.data.positions.emplace_back((u + 0.3) * size, (v - 0.4) * size * std::sin(tilt) - 1.0,
                                         (v - 0.4) * size * std::cos(tilt));
      part.data.triangles = {{0, 1, 2}, {0, 2, 3}};
      return meshOf(part, glm::dmat4(1.0));
    }
    case 1:
      traits += fmt::format("; planet of radius {:.2g}", size);
      return sphereMesh(dvec3(0.0, -size - 1.0, 0.0), size);
    default: {
      traits += fmt::format("; stray triangle {:.2g} away", size);
      Part part{"stray", {}};
      const dvec3 at = size * draw.direction();
      part.data.positions = {at, at + 0.1 * size * draw.point(), at + 0.1 * size * draw.point()};
      part.data.triangles = {{0, 1, 2}};
      return meshOf(part, glm::dmat4(1.0));
    }
  }
}

void giveMaterials(const Kind& kind, Scene& scene, Draw& draw) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    Bsdf& bsdf = scene.meshes[i].bsdf;
    bsdf.row = kind.bsdfs[i % kind.bsdfs.size()];
    if (const PropertyRow* color = albedoOf(*bsdf.row); color != nullptr &&
                                                        std::string(color->name) != "eta" &&
                                                        std::string(color->name) != "intIOR")
      bsdf.set(color->name, draw.color());
    for (const PropertyRow& property : bsdf.row->properties) {
      const std::string name = property.name;
      if (name == "alpha") bsdf.set(name, draw.scale(0.02, 0.7));
      if (name == "roughness") bsdf.set(name, draw.between(0.2, 1.0));
      if (name == "shininess") bsdf.set(name, draw.scale(0.5, 100.0));
      if (name == "intIOR" && property.type == PropertyType::Float)
        bsdf.set(name, draw.between(0.7, 2.5));
    }
  }
  if (kind.texture != nullptr)
    scene.meshes[0].bsdf.show("albedo", randomTexture(*kind.texture, draw));
}

/// What makes frames around the normals, or turns them.
void giveFrames(const Kind& kind, Scene& scene, Draw draw, std::string& traits) {
  if (!kind.integrator->needs.materials) return;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    Bsdf& bsdf = scene.meshes[i].bsdf;
    for (const PropertyRow& property : bsdf.row->properties)
      if (kind.anisotropic && std::string(property.name) == "anisotropic")
        bsdf.set(property.name, draw.between(0.1, 1.0));
    if (kind.bends == nullptr || i > 2) continue;
    Texture map = randomTexture(*kind.bends, draw);
    for (dvec3& color : map.colors)
      color = dvec3(0.5, 0.5, 1.0) + 0.4 * draw.point() * dvec3(1, 1, 0.5);
    bsdf.show(kNormalMap, map);
  }
  if (kind.bends != nullptr) traits += fmt::format("; {} as normal map", kind.bends->name);
}

/// For paths, nothing would account for surfaces that are contested at later hits.
void addMeshes(const Kind& kind, Scene& scene, Draw& draw, std::string& traits) {
  const int count = draw.integer(3, 6);
  for (int i = 0; i < count; ++i) {
    const bool copies = i > 0 && draw.chance(0.15);
    scene.meshes.push_back(copies ? copied(scene.meshes.back(), kind.explained(), draw, traits)
                           : draw.chance(0.3) ? randomSphere(scene.meshes, draw, traits)
                                              : randomTriangles(kind.explained(), draw, traits));
  }
  if (draw.chance(0.3)) scene.meshes.push_back(largePart(draw, traits));
  giveMaterials(kind, scene, draw);
}

/// Of another unit, and somewhere else. Triangles that have no area there are dropped, as from a
/// file.
void moveAway(Scene& scene, Draw& draw, std::string& traits) {
  const double scale = draw.chance(0.4) ? draw.scale(1e-4, 1e6) : 1.0;
  const dvec3 offset =
      draw.chance(0.2) ? scale * draw.scale(1.0, 1e6) * draw.direction() : dvec3(0.0);
  traits += fmt::format("; scale {:.2g}, offset {:.2g}", scale, glm::length(offset));
  const glm::dmat4 toWorld = placed(offset, scale, glm::dmat4(1.0));
  for (Mesh& mesh : scene.meshes) {
    Mesh moved =
        meshOf({"", {mesh.positions, mesh.normals, mesh.uvs, mesh.triangles, {}}}, toWorld);
    if (mesh.sphere)
      moved.sphere = Sphere{mesh.sphere->centre * scale + offset, mesh.sphere->radius * scale};
    moved.bsdf = mesh.bsdf;
    moved.light = mesh.light;
    mesh = std::move(moved);
  }
  for (PointLight& light : scene.lights) {
    light.position = light.position * scale + offset;
    if (light.row != &emitters::directional) light.radiance *= scale * scale;
  }
  if (std::string(scene.integrator.row->name) == "simple") {
    scene.integrator.set("position", scene.integrator.triple("position") * scale + offset);
    scene.integrator.set("energy", scene.integrator.triple("energy") * scale * scale);
  }
  if (scene.integrator.is(integrators::averageVisibility))
    scene.integrator.set("length", scene.integrator.real("length") * scale);
  Camera& camera = scene.camera;
  camera.toWorld[3] = glm::dvec4(dvec3(camera.toWorld[3]) * scale + offset, 1.0);
  camera.nearClip *= scale;
  camera.farClip *= scale;
  camera.lensRadius *= scale;
  camera.focalDistance *= scale;
}

}  // namespace

RandomScene randomScene(std::uint64_t seed) {
  RandomScene result{kindOf(seed), {}, {}};
  const Kind& kind = result.kind;
  Scene& scene = result.scene;
  Draw draw(seed ^ 0x5eed000000000000U);
  result.traits = kind.integrator->name;
  scene.file = fmt::format("seed {}", seed);
  scene.integrator = {kind.integrator};
  scene.filter = kind.filter;
  scene.sampler = {static_cast<std::uint32_t>(draw.integer(1, 4)),
                   static_cast<std::int64_t>(seed % 1000), kind.sampler};
  addMeshes(kind, scene, draw, result.traits);
  giveFrames(kind, scene, Draw(seed ^ 0xf4a3e50000000000U), result.traits);
  addLighting(kind, scene, draw, result.traits);
  chooseView(kind, scene, draw, result.traits);
  moveAway(scene, draw, result.traits);
  return result;
}

}  // namespace laver::test
