#include <fmt/format.h>

#include <array>
#include <cmath>

#include "scene/scene.h"

namespace laver {
namespace {

struct IntegratorName {
  Integrator integrator;
  const char* name;    // in the XML
  const char* object;  // in the dump; nullptr: a layer, which no scene names
};
constexpr std::array kIntegrators = {
    IntegratorName{Integrator::Normals, "normals", "NormalIntegrator"},
    IntegratorName{Integrator::DirectWhitted, "direct_whitted", "DirectWhittedIntegrator"},
    IntegratorName{Integrator::Depth, "depth", "DepthIntegrator"},
    IntegratorName{Integrator::AverageVisibility, "av", "AverageVisibilityIntegrator"},
    IntegratorName{Integrator::AmbientOcclusion, "ao", "AmbientOcclusionIntegrator"},
    IntegratorName{Integrator::ShadingNormal, "shading_normal", nullptr},
    IntegratorName{Integrator::Albedo, "albedo", nullptr}};

struct FilterName {
  Filter::Kind kind;
  const char* name;
  double radius;  // pixels, as in objects.cpp
};
// In the order of Filter::Kind.
constexpr std::array kFilters = {FilterName{Filter::Kind::Gaussian, "gaussian", 2.0},
                                 FilterName{Filter::Kind::Mitchell, "mitchell", 2.0},
                                 FilterName{Filter::Kind::Tent, "tent", 1.0},
                                 FilterName{Filter::Kind::Box, "box", 0.5}};

const IntegratorName& entry(Integrator integrator) {
  for (const IntegratorName& candidate : kIntegrators) {
    if (candidate.integrator == integrator) return candidate;
  }
  return kIntegrators[0];
}

struct SamplerName {
  Sampler::Kind kind;
  const char* name;
  const char* object;
};
constexpr std::array kSamplers = {
    SamplerName{Sampler::Kind::Independent, "independent", "Independent"},
    SamplerName{Sampler::Kind::Stratified, "stratified", "Stratified"},
    SamplerName{Sampler::Kind::Sobol, "sobol", "Sobol"}};

const SamplerName& entry(Sampler::Kind kind) {
  for (const SamplerName& candidate : kSamplers) {
    if (candidate.kind == kind) return candidate;
  }
  return kSamplers[0];
}

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

std::string describeIntegrator(const Scene& scene) {
  const bool av = scene.integrator == Integrator::AverageVisibility;
  return fmt::format("{}[{}]", entry(scene.integrator).object,
                     av ? fmt::format("length={:g}", scene.avLength) : "");
}

std::string describeFilter(const Filter& filter) {
  switch (filter.kind) {
    case Filter::Kind::Gaussian:
      return fmt::format("GaussianFilter[radius={:f}, stddev={:f}]", filter.radius, filter.stddev);
    case Filter::Kind::Mitchell:
      return fmt::format("MitchellNetravaliFilter[radius={:f}, B={:f}, C={:f}]", filter.radius,
                         filter.B, filter.C);
    case Filter::Kind::Tent:
      return "TentFilter[]";
    case Filter::Kind::Box:
      return "BoxFilter[]";
  }
  return {};
}

std::string describeSampler(const Sampler& sampler) {
  const std::string seed = sampler.seed == 0 ? "" : fmt::format(", seed={}", sampler.seed);
  return fmt::format("{}[sampleCount={}{}]", entry(sampler.kind).object, sampler.sampleCount, seed);
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

std::string describeAlbedo(const Diffuse& bsdf) {
  return bsdf.texture ? describeTexture(*bsdf.texture) : triple(bsdf.albedo);
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
        "      bsdf = Diffuse[\n        albedo = {}\n      ],\n      emitter = null\n    ]",
        triple(mesh.sphere->centre), mesh.sphere->radius, describeAlbedo(mesh.bsdf));
  return fmt::format(
      "    Mesh[\n      name = \"{}\",\n      vertexCount = {},\n      triangleCount = {},\n"
      "      bsdf = Diffuse[\n        albedo = {}\n      ],\n      emitter = null\n    ]",
      mesh.name, mesh.positions.size(), mesh.triangles.size(), describeAlbedo(mesh.bsdf));
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

const char* integratorName(Integrator integrator) { return entry(integrator).name; }

std::optional<Integrator> integratorFromName(const std::string& name) {
  for (const IntegratorName& candidate : kIntegrators) {
    if (candidate.name == name && candidate.object != nullptr) return candidate.integrator;
  }
  return std::nullopt;
}

const char* filterName(Filter::Kind kind) { return kFilters[static_cast<std::size_t>(kind)].name; }

std::optional<Filter> filterFromName(const std::string& name) {
  for (const FilterName& candidate : kFilters) {
    if (candidate.name == name) return Filter{candidate.kind, candidate.radius};
  }
  return std::nullopt;
}

const char* samplerName(Sampler::Kind kind) { return entry(kind).name; }

std::optional<Sampler::Kind> samplerFromName(const std::string& name) {
  for (const SamplerName& candidate : kSamplers) {
    if (candidate.name == name) return candidate.kind;
  }
  return std::nullopt;
}

glm::uvec2 strataOf(std::uint32_t sampleCount) {
  auto columns = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(sampleCount)));
  while (sampleCount % columns != 0) --columns;
  return {columns, sampleCount / columns};
}

std::string describe(const Scene& scene) {
  // The missing comma behind the sampler is Nori's.
  std::string text = fmt::format(
      "Scene[\n  integrator = {},\n  sampler = {}\n  camera = {},\n  medium = null,\n"
      "  envEmitter = {},\n",
      describeIntegrator(scene), describeSampler(scene.sampler),
      describeCamera(scene.camera, scene.filter), describeEnvironment(scene.environment));
  if (!scene.lights.empty()) {
    text += fmt::format("  emitters = {},\n", list(scene.lights, describeLight));
  }
  return text + fmt::format("  meshes = {}\n]", list(scene.meshes, describeMesh));
}

}  // namespace laver
