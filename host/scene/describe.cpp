#include <fmt/format.h>

#include "scene/scene.h"

namespace laver {
namespace {

// No negative zero.
double plain(double x) { return x == 0.0 ? 0.0 : x; }

std::string triple(const glm::dvec3& v) {
  return fmt::format("[{:g}, {:g}, {:g}]", plain(v.x), plain(v.y), plain(v.z));
}

// Rows, the later ones under the first number.
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
  for (const PropertyRow& property : use.row->properties)
    properties += fmt::format("{}{}={:g}", properties.empty() ? "" : ", ", property.name,
                              use.real(property.name));
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
  return fmt::format(
      "PerspectiveCamera[\n{}{},\n    outputSize = [{}, {}],\n    fov = {:f},\n"
      "    clip = [{:f}, {:f}],\n    rfilter = {}\n  ]",
      key, rows(camera.toWorld, key.size()), camera.width, camera.height, camera.fov,
      camera.nearClip, camera.farClip, describeFilter(filter));
}

std::string describeLight(const PointLight& light) {
  return fmt::format("    PointEmitter[\n      position = {},\n      radiance = {}\n    ]",
                     triple(light.position), triple(light.radiance));
}

std::string describeTexture(const Texture& texture) {
  const std::string place =
      fmt::format("scale = [{:g}, {:g}], offset = [{:g}, {:g}]", texture.scale.x, texture.scale.y,
                  plain(texture.offset.x), plain(texture.offset.y));
  if (texture.kind == Texture::Kind::Checker)
    return fmt::format("CheckerTexture[color1 = {}, color2 = {}, {}]", triple(texture.colors[0]),
                       triple(texture.colors[1]), place);
  return fmt::format("Texture[name = \"{}\", color = {}, {}]", texture.filename,
                     triple(texture.colors[0]), place);
}

std::string describeBsdf(const Bsdf& bsdf) {
  std::string properties;
  for (const PropertyRow& property : bsdf.row->properties) {
    const bool colour = property.type == PropertyType::Color;
    const std::string value = !colour        ? fmt::format("{:f}", bsdf.real(property.name))
                              : bsdf.texture ? describeTexture(*bsdf.texture)
                                             : triple(bsdf.albedo);
    properties +=
        fmt::format("{}        {} = {}", properties.empty() ? "\n" : ",\n", property.name, value);
  }
  return fmt::format("{}[{}{}]", bsdf.row->object, properties,
                     properties.empty() ? "" : "\n      ");
}

std::string describeEnvironment(const std::optional<Environment>& environment) {
  if (!environment) return "null";
  const std::string key = "    toWorld = ";
  return fmt::format(
      "EnvironmentEmitter[\n    radiance = {},\n    environment = \"{}\",\n{}{}\n  ]",
      triple(environment->radiance), environment->filename, key,
      rows(environment->toWorld, key.size()));
}

std::string describeMesh(const Mesh& mesh) {
  if (mesh.sphere)
    return fmt::format(
        "    Sphere[\n      center = {},\n      radius = {:g},\n"
        "      bsdf = {},\n      emitter = null\n    ]",
        triple(mesh.sphere->centre), mesh.sphere->radius, describeBsdf(mesh.bsdf));
  return fmt::format(
      "    Mesh[\n      name = \"{}\",\n      vertexCount = {},\n      triangleCount = {},\n"
      "      bsdf = {},\n      emitter = null\n    ]",
      mesh.name, mesh.positions.size(), mesh.triangles.size(), describeBsdf(mesh.bsdf));
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
  // The missing comma behind the sampler is Nori's.
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
