#include <fmt/format.h>

#include "scene/dump.h"
#include "scene/scene.h"

namespace laver {
namespace {

using dump::plain;
using dump::triple;

// The rows of a matrix, aligned below the first one.
std::string rows(const glm::dmat4& m, std::size_t column) {
  std::string text = "[";
  for (int r = 0; r < 4; ++r) {
    text += fmt::format("{:g}, {:g}, {:g}, {:g}", plain(m[0][r]), plain(m[1][r]), plain(m[2][r]),
                        plain(m[3][r]));
    text += r < 3 ? ";\n" + std::string(column + 1, ' ') : "]";
  }
  return text;
}

std::string describeIntegrator(const IntegratorUse& use) {
  std::string properties;
  const auto add = [&](const std::string& name, const Value& value) {
    const auto* real = std::get_if<double>(&value);
    properties += fmt::format("{}{}={}", properties.empty() ? "" : ", ", name,
                              real != nullptr ? fmt::format("{:g}", *real) : textOf(value));
  };
  for (const PropertyRow& row : use.row->properties)
    add(row.name, valueOf(use.row->properties, use.values, row.name));
  if (use.user)
    for (const NamedValue& value : use.values) add(value.name, value.value);
  return fmt::format("{}[{}]", use.row->object, properties);
}

std::string describeFilter(const Filter& filter) {
  std::string properties;
  for (std::size_t i = 0; i < filter.row->properties.size(); ++i)
    properties += fmt::format("{}{}={:f}", i == 0 ? "" : ", ", filter.row->properties[i].name,
                              filter.*filter.row->members[i]);
  return fmt::format("{}[{}]", filter.row->object, properties);
}

std::string describeSampler(const Sampler& sampler) {
  const std::string seed = sampler.seed == 0 ? "" : fmt::format(", seed={}", sampler.seed);
  return fmt::format("{}[sampleCount={}{}]", sampler.row->object, sampler.sampleCount, seed);
}

std::string describeCamera(const Camera& camera, const Filter& filter) {
  const std::string key = "    cameraToWorld = ";
  const std::string lens = camera.row->lens
                               ? fmt::format("    lensRadius = {:f},\n    focalDistance = {:f},\n",
                                             camera.lensRadius, camera.focalDistance)
                               : "";
  return fmt::format(
      "{}[\n{}{},\n    outputSize = [{}, {}],\n    fov = {:f},\n"
      "    clip = [{:f}, {:f}],\n{}    rfilter = {}\n  ]",
      camera.row->object, key, rows(camera.toWorld, key.size()), camera.width, camera.height,
      camera.fov, camera.nearClip, camera.farClip, lens, describeFilter(filter));
}

std::string describeLight(const PointLight& light) {
  return fmt::format("    {}[\n      position = {},\n      radiance = {}\n    ]", light.row->object,
                     triple(light.position), triple(light.radiance));
}

std::string describeTexture(const Texture& texture) {
  const std::string place =
      fmt::format("scale = [{:g}, {:g}], offset = [{:g}, {:g}]", texture.scale.x, texture.scale.y,
                  plain(texture.offset.x), plain(texture.offset.y));
  return fmt::format("{}[{}, {}]", texture.row->object, texture.row->describe(texture), place);
}

std::string describeProperty(const Bsdf& bsdf, const PropertyRow& property) {
  if (const Texture* texture = bsdf.texture(property.name)) return describeTexture(*texture);
  if (property.type == PropertyType::String)
    return fmt::format(
        "\"{}\"", std::get<std::string>(valueOf(bsdf.row->properties, bsdf.values, property.name)));
  if (property.type == PropertyType::Color) return triple(bsdf.color(property.name));
  return fmt::format("{:f}", bsdf.real(property.name));
}

std::string describeBsdf(const Bsdf& bsdf) {
  std::string properties;
  for (const PropertyRow& property : bsdf.row->properties) {
    properties += fmt::format("{}        {} = {}", properties.empty() ? "\n" : ",\n", property.name,
                              describeProperty(bsdf, property));
  }
  if (const Texture* map = bsdf.texture(kNormalMap))
    properties += fmt::format("{}        normal = {}", properties.empty() ? "\n" : ",\n",
                              describeTexture(*map));
  return fmt::format("{}[{}{}]", bsdf.row->object, properties,
                     properties.empty() ? "" : "\n      ");
}

std::string describeEnvironment(const std::optional<Environment>& environment) {
  if (!environment) return "null";
  const std::string key = "    toWorld = ";
  return fmt::format("{}[\n    radiance = {},\n    {},\n{}{}\n  ]", environment->row->object,
                     triple(environment->radiance), environment->row->describe(*environment), key,
                     rows(environment->toWorld, key.size()));
}

std::string describeRadiance(const AreaLight& light) {
  if (!light.texture) return triple(light.radiance);
  return fmt::format("{:g} * {}", light.scale, describeTexture(*light.texture));
}

std::string describeMesh(const Mesh& mesh) {
  const std::string shape =
      mesh.sphere ? fmt::format("center = {},\n      radius = {:g}", triple(mesh.sphere->centre),
                                mesh.sphere->radius)
                  : fmt::format("name = \"{}\",\n      vertexCount = {},\n      triangleCount = {}",
                                mesh.name, mesh.positions.size(), mesh.triangles.size());
  const std::string light = mesh.light ? fmt::format("{}[radiance = {}]", emitters::area.object,
                                                     describeRadiance(*mesh.light))
                                       : "null";
  return fmt::format("    {}[\n      {},\n      bsdf = {},\n      emitter = {}\n    ]",
                     mesh.row().object, shape, describeBsdf(mesh.bsdf), light);
}

template <class T>
std::string list(const std::vector<T>& items, std::string (*describeItem)(const T&)) {
  std::string text = "{\n";
  for (std::size_t i = 0; i < items.size(); ++i) {
    text += describeItem(items[i]);
    text += i + 1 < items.size() ? ",\n" : "\n";
  }
  return text + "  }";
}

}  // namespace

std::string describe(const Scene& scene) {
  // The missing comma after the sampler is Nori's.
  std::string text = fmt::format(
      "Scene[\n  integrator = {},\n  sampler = {}\n  camera = {},\n  medium = null,\n"
      "  envEmitter = {},\n",
      describeIntegrator(scene.integrator), describeSampler(scene.sampler),
      describeCamera(scene.camera, scene.filter), describeEnvironment(scene.environment));
  if (!scene.lights.empty()) {
    text += fmt::format("  emitters = {},\n", list(scene.lights, describeLight));
  }
  return text + fmt::format("  meshes = {}\n]", list(scene.meshes, describeMesh));
}

}  // namespace laver
