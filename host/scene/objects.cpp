// The objects that laver has: a table of properties and a function each.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "scene/properties.h"
#include "scene/schema.h"
#include "scene/texture_objects.h"

namespace laver::xml {
namespace {

using enum PropertyType;

double positive(const Properties& given, const char* name) {
  const double value = given.real(name);
  if (!(value > 0.0))
    given.error(name, fmt::format("{} must be more than 0, found {}", name, value));
  return value;
}

template <Integrator kKind>
void buildIntegrator(const Properties&, std::string_view, Draft& draft) {
  if (!draft.overrides.integrator) draft.scene.integrator = kKind;
}

constexpr std::array kAverageVisibility = {PropertyRule{"length", Float, nullptr}};

void buildAverageVisibility(const Properties& given, std::string_view parent, Draft& draft) {
  buildIntegrator<Integrator::AverageVisibility>(given, parent, draft);
  if (given.has("length")) draft.scene.avLength = positive(given, "length");
}

constexpr std::array kCamera = {
    PropertyRule{"toWorld", Transform, ""},    PropertyRule{"width", Integer, "1280"},
    PropertyRule{"height", Integer, "720"},    PropertyRule{"fov", Float, "30"},
    PropertyRule{"nearClip", Float, "0.0001"}, PropertyRule{"farClip", Float, "10000"}};

int filmEdge(const Properties& given, const char* name, std::int64_t pixels) {
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  if (pixels >= 1 && pixels <= kMost) return static_cast<int>(pixels);
  given.error(name, fmt::format("{} must be 1 to {} pixels, found {}", name, kMost, pixels));
  return 1;
}

void buildCamera(const Properties& given, std::string_view, Draft& draft) {
  Camera& camera = draft.scene.camera;
  const auto& size = draft.overrides.size;
  camera.toWorld = given.transform("toWorld");
  camera.width = filmEdge(given, "width", size ? size->x : given.integer("width"));
  camera.height = filmEdge(given, "height", size ? size->y : given.integer("height"));
  camera.fov = given.real("fov");
  camera.nearClip = given.real("nearClip");
  camera.farClip = given.real("farClip");
  constexpr std::int64_t kMostPixels = std::numeric_limits<int>::max();
  if (std::int64_t{camera.width} * camera.height > kMostPixels) {
    given.error("width", fmt::format("a film of {}x{} has more than {} pixels", camera.width,
                                     camera.height, kMostPixels));
  }
  if (!(camera.fov > 0.0 && camera.fov < 180.0)) {
    given.error("fov", fmt::format("fov must be more than 0 and less than 180 degrees, found {}",
                                   camera.fov));
  }
  if (!(camera.nearClip > 0.0)) {
    given.error("nearClip", fmt::format("nearClip must be more than 0, found {}", camera.nearClip));
  }
  if (!(camera.farClip > camera.nearClip)) {
    given.error("farClip", fmt::format("farClip must be more than nearClip ({}), found {}",
                                       camera.nearClip, camera.farClip));
  }
}

constexpr std::array kSampler = {PropertyRule{"sampleCount", Integer, "1"},
                                 PropertyRule{"seed", Integer, "0"}};

// Long strata leave one axis nearly to chance.
void checkStrata(const Properties& given, std::uint32_t count) {
  const glm::uvec2 strata = strataOf(count);
  if (strata.y <= 2 * strata.x) return;
  const auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(count)));
  given.warning(
      "sampleCount",
      fmt::format("{} samples make strata of {} x {} a pixel: {} or {} would make squares", count,
                  strata.x, strata.y, root * root, (root + 1) * (root + 1)));
}

template <Sampler::Kind kKind>
void buildSampler(const Properties& given, std::string_view, Draft& draft) {
  const SceneOverrides& overrides = draft.overrides;
  const std::int64_t count =
      overrides.sampleCount ? std::int64_t{*overrides.sampleCount} : given.integer("sampleCount");
  constexpr std::int64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (count < 1 || count > kMost) {
    given.error("sampleCount", fmt::format("sampleCount must be 1 to {}, found {}", kMost, count));
  }
  draft.scene.sampler.sampleCount = static_cast<std::uint32_t>(count);
  draft.scene.sampler.seed = overrides.seed.value_or(given.integer("seed"));
  draft.scene.sampler.kind = kKind;
  if (kKind == Sampler::Kind::Stratified && count >= 1 && count <= kMost)
    checkStrata(given, draft.scene.sampler.sampleCount);
}

constexpr std::array kGaussian = {PropertyRule{"radius", Float, "2"},
                                  PropertyRule{"stddev", Float, "0.5"}};
constexpr std::array kMitchell = {PropertyRule{"radius", Float, "2"},
                                  PropertyRule{"B", Float, "0.3333333333333333"},
                                  PropertyRule{"C", Float, "0.3333333333333333"}};

void buildGaussian(const Properties& given, std::string_view, Draft& draft) {
  Filter& filter = draft.scene.filter;
  filter.kind = Filter::Kind::Gaussian;
  filter.radius = positive(given, "radius");
  filter.stddev = positive(given, "stddev");
}

void buildMitchell(const Properties& given, std::string_view, Draft& draft) {
  Filter& filter = draft.scene.filter;
  filter.kind = Filter::Kind::Mitchell;
  filter.radius = positive(given, "radius");
  filter.B = given.real("B");
  filter.C = given.real("C");
}

// Nori's tent and box have fixed radii.
void buildTent(const Properties&, std::string_view, Draft& draft) {
  draft.scene.filter.kind = Filter::Kind::Tent;
  draft.scene.filter.radius = 1.0;
}

void buildBox(const Properties&, std::string_view, Draft& draft) {
  draft.scene.filter.kind = Filter::Kind::Box;
  draft.scene.filter.radius = 0.5;
}

constexpr std::array kObj = {PropertyRule{"filename", String, nullptr},
                             PropertyRule{"toWorld", Transform, ""}};

void buildObj(const Properties& given, std::string_view, Draft& draft) {
  // Without a file name the mesh still takes its children.
  std::string name;
  if (given.has("filename")) {
    name = given.text("filename");
    if (name.empty()) given.error("filename", "filename is empty, expected an OBJ file");
  }
  draft.meshes.push_back({given.offset(), name, given.transform("toWorld"), {}, 0, {}});
}

constexpr std::array kSphere = {PropertyRule{"center", Point, "0 0 0"},
                                PropertyRule{"radius", Float, "1"}};

void buildSphere(const Properties& given, std::string_view, Draft& draft) {
  const Sphere sphere{given.triple("center"), positive(given, "radius")};
  draft.meshes.push_back({given.offset(), "", glm::dmat4(1.0), {}, 0, sphere});
}

constexpr std::array kDiffuse = {PropertyRule{"albedo", Color, "0.5 0.5 0.5"}};

void buildDiffuse(const Properties& given, std::string_view, Draft& draft) {
  if (!draft.meshes.empty()) draft.meshes.back().bsdf.albedo = given.triple("albedo");
}

void addLight(const PointLight& light, std::string_view parent, Draft& draft) {
  (parent == "mesh" ? draft.meshLights : draft.scene.lights).push_back(light);
}

constexpr std::array kPointLight = {PropertyRule{"position", Point, "0 100 0"},
                                    PropertyRule{"radiance", Color, "1 1 1"}};
constexpr std::array kPowerLight = {PropertyRule{"position", Point, "0 100 0"},
                                    PropertyRule{"power", Color, nullptr}};

void buildPointLight(const Properties& given, std::string_view parent, Draft& draft) {
  addLight({given.triple("position"), given.triple("radiance")}, parent, draft);
}

void buildPowerLight(const Properties& given, std::string_view parent, Draft& draft) {
  if (!given.has("power")) return;
  const glm::dvec3 radiance = given.triple("power") / (4.0 * glm::pi<double>());
  addLight({given.triple("position"), radiance}, parent, draft);
}

constexpr std::array kObjects = {
    ObjectRule{"integrator", "normals", {}, buildIntegrator<Integrator::Normals>},
    ObjectRule{"integrator", "direct_whitted", {}, buildIntegrator<Integrator::DirectWhitted>},
    ObjectRule{"integrator", "depth", {}, buildIntegrator<Integrator::Depth>},
    ObjectRule{"integrator", "av", kAverageVisibility, buildAverageVisibility},
    ObjectRule{"integrator", "ao", {}, buildIntegrator<Integrator::AmbientOcclusion>},
    ObjectRule{"camera", "perspective", kCamera, buildCamera},
    ObjectRule{"sampler", "independent", kSampler, buildSampler<Sampler::Kind::Independent>},
    ObjectRule{"sampler", "stratified", kSampler, buildSampler<Sampler::Kind::Stratified>},
    ObjectRule{"sampler", "sobol", kSampler, buildSampler<Sampler::Kind::Sobol>},
    ObjectRule{"rfilter", "gaussian", kGaussian, buildGaussian},
    ObjectRule{"rfilter", "mitchell", kMitchell, buildMitchell},
    ObjectRule{"rfilter", "tent", {}, buildTent},
    ObjectRule{"rfilter", "box", {}, buildBox},
    ObjectRule{"mesh", "obj", kObj, buildObj},
    ObjectRule{"mesh", "sphere", kSphere, buildSphere},
    ObjectRule{"bsdf", "diffuse", kDiffuse, buildDiffuse},
    ObjectRule{"emitter", "pointlight", kPointLight, buildPointLight},
    ObjectRule{"emitter", "point", kPowerLight, buildPowerLight},
    ObjectRule{"emitter", "environment", kEnvironment, buildEnvironment},
    ObjectRule{"emitter", "envmap", kEnvironment, buildEnvmap},
    ObjectRule{"emitter", "constant", kConstant, buildConstant},
    ObjectRule{"texture", "checker", kChecker, buildChecker},
    ObjectRule{"texture", "textmap", kTextmap, buildTextmap},
    ObjectRule{"texture", "image_texture", kTextmap, buildTextmap},
    ObjectRule{"texture", "bitmap", kTextmap, buildTextmap},
};

}  // namespace

std::span<const ObjectRule> objectRules() { return kObjects; }

}  // namespace laver::xml
