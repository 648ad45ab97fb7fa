// The objects that laver has: a table of properties and a function each.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

#include "scene/properties.h"
#include "scene/schema.h"
#include "scene/texture_objects.h"

namespace laver::xml {
namespace {

using enum PropertyType;

/// The row that an object's type names.
template <class Row>
const Row& rowOf(const Properties& given, const Rows<Row>& rows) {
  return *rowCalled(rows, given.rule().type);
}

void buildIntegrator(const Properties& given, std::string_view, Draft& draft) {
  IntegratorUse use{&rowOf(given, integratorRows())};
  for (const PropertyRow& property : use.row->properties)
    if (given.has(property.name)) setValue(use.values, property.name, given.real(property.name));
  draft.scene.fileIntegrator = use;
  if (!draft.overrides.integrator) draft.scene.integrator = use;
}

std::vector<PropertyRow> cameraProperties() {
  constexpr Range kPixels = fromTo(1, std::numeric_limits<int>::max());
  const Camera camera;
  return {
      {.name = "toWorld",
       .type = Transform,
       .start = camera.toWorld,
       .meaning = "from the camera, which looks along +z with +x to the left and +y up"},
      {.name = "width",
       .type = Integer,
       .start = std::int64_t{camera.width},
       .range = kPixels,
       .unit = "pixels",
       .meaning = "of the film"},
      {.name = "height",
       .type = Integer,
       .start = std::int64_t{camera.height},
       .range = kPixels,
       .unit = "pixels",
       .meaning = "of the film"},
      {.name = "fov",
       .type = Float,
       .start = camera.fov,
       .range = between(0.0, 180.0),
       .unit = "degrees",
       .meaning = "horizontal field of view"},
      {.name = "nearClip",
       .type = Float,
       .start = camera.nearClip,
       .range = moreThan(0.0),
       .unit = "camera units",
       .meaning = "nothing in front of this plane is seen"},
      {.name = "farClip",
       .type = Float,
       .start = camera.farClip,
       .unit = "camera units",
       .meaning = "nothing behind this plane is seen"},
  };
}

void buildCamera(const Properties& given, std::string_view, Draft& draft) {
  using Pixels = std::optional<std::int64_t>;
  Camera& camera = draft.scene.camera;
  const auto& size = draft.overrides.size;
  const auto edge = [&](const char* name, const Pixels& instead) {
    return static_cast<int>(given.integer(name, instead));
  };
  camera.toWorld = given.transform("toWorld");
  camera.width = edge("width", size ? Pixels(size->x) : Pixels());
  camera.height = edge("height", size ? Pixels(size->y) : Pixels());
  camera.fov = given.real("fov");
  camera.nearClip = given.real("nearClip");
  camera.farClip = given.real("farClip");
  constexpr std::int64_t kMostPixels = std::numeric_limits<int>::max();
  if (std::int64_t{camera.width} * camera.height > kMostPixels) {
    given.error("width", fmt::format("a film of {}x{} has more than {} pixels", camera.width,
                                     camera.height, kMostPixels));
  }
  if (!(camera.farClip > camera.nearClip)) {
    given.error("farClip", fmt::format("farClip must be more than nearClip ({}), found {}",
                                       camera.nearClip, camera.farClip));
  }
}

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

void buildSampler(const Properties& given, std::string_view, Draft& draft) {
  const SceneOverrides& overrides = draft.overrides;
  Sampler& sampler = draft.scene.sampler;
  sampler.row = &rowOf(given, samplerRows());
  sampler.sampleCount =
      static_cast<std::uint32_t>(given.integer("sampleCount", overrides.sampleCount));
  sampler.seed = given.integer("seed", overrides.seed);
  if (sampler.row->strata) checkStrata(given, sampler.sampleCount);
}

void buildFilter(const Properties& given, std::string_view, Draft& draft) {
  const FilterRow& row = rowOf(given, filterRows());
  Filter filter = filterOf(row);
  for (std::size_t i = 0; i < row.properties.size(); ++i)
    filter.*row.members[i] = given.real(row.properties[i].name);
  draft.scene.filter = filter;
}

const std::vector<PropertyRow> kObj = {
    {.name = "filename", .type = String, .required = true},
    {.name = "toWorld", .type = Transform, .start = glm::dmat4(1.0)}};

void buildObj(const Properties& given, std::string_view, Draft& draft) {
  // Without a file name the mesh still takes its children.
  std::string name;
  if (given.has("filename")) {
    name = given.text("filename");
    if (name.empty()) given.error("filename", "filename is empty, expected an OBJ file");
  }
  draft.meshes.push_back({given.offset(), name, given.transform("toWorld"), {}, 0, {}});
}

const std::vector<PropertyRow> kSphere = {
    {.name = "center", .type = Point, .start = Sphere{}.centre},
    {.name = "radius", .type = Float, .start = Sphere{}.radius, .range = moreThan(0.0)}};

void buildSphere(const Properties& given, std::string_view, Draft& draft) {
  const Sphere sphere{given.triple("center"), given.real("radius")};
  draft.meshes.push_back({given.offset(), "", glm::dmat4(1.0), {}, 0, sphere});
}

void buildBsdf(const Properties& given, std::string_view, Draft& draft) {
  if (draft.meshes.empty()) return;
  Bsdf& bsdf = draft.meshes.back().bsdf;
  bsdf.row = &rowOf(given, bsdfRows());
  bsdf.albedo = glm::dvec3(1.0);
  for (const PropertyRow& property : bsdf.row->properties) {
    if (property.type == Color)
      bsdf.albedo = given.triple(property.name);
    else if (given.has(property.name))
      setValue(bsdf.values, property.name, given.real(property.name));
  }
}

void addLight(const PointLight& light, std::string_view parent, Draft& draft) {
  (parent == "mesh" ? draft.meshLights : draft.scene.lights).push_back(light);
}

const std::vector<PropertyRow> kPointLight = {
    {.name = "position", .type = Point, .start = PointLight{}.position},
    {.name = "radiance", .type = Color, .start = PointLight{}.radiance}};
const std::vector<PropertyRow> kPowerLight = {
    {.name = "position", .type = Point, .start = PointLight{}.position},
    {.name = "power", .type = Color, .start = glm::dvec3(0.0), .required = true}};

void buildPointLight(const Properties& given, std::string_view parent, Draft& draft) {
  addLight({given.triple("position"), given.triple("radiance")}, parent, draft);
}

void buildPowerLight(const Properties& given, std::string_view parent, Draft& draft) {
  if (!given.has("power")) return;
  const glm::dvec3 radiance = given.triple("power") / (4.0 * glm::pi<double>());
  addLight({given.triple("position"), radiance}, parent, draft);
}

using Build = void (*)(const Properties& given, std::string_view parent, Draft& draft);

/// Adds a rule for each name of each row.
template <class Row>
void add(std::vector<ObjectRule>& rules, const char* tag, const Rows<Row>& rows, Build build) {
  for (const Row* row : rows) {
    rules.push_back({tag, row->name, row->properties, build});
    for (const char* spelling : row->spellings)
      rules.push_back({tag, spelling, row->properties, build});
  }
}

std::vector<ObjectRule> makeRules() {
  std::vector<ObjectRule> rules;
  static const std::vector<PropertyRow> camera = cameraProperties();
  add(rules, "integrator", integratorRows(), buildIntegrator);
  rules.push_back({"camera", "perspective", camera, buildCamera});
  add(rules, "sampler", samplerRows(), buildSampler);
  add(rules, "rfilter", filterRows(), buildFilter);
  add(rules, "bsdf", bsdfRows(), buildBsdf);
  const ObjectRule others[] = {{"mesh", "obj", kObj, buildObj},
                               {"mesh", "sphere", kSphere, buildSphere},
                               {"emitter", "pointlight", kPointLight, buildPointLight},
                               {"emitter", "point", kPowerLight, buildPowerLight},
                               {"emitter", "environment", kEnvironment, buildEnvironment},
                               {"emitter", "envmap", kEnvironment, buildEnvmap},
                               {"emitter", "constant", kConstant, buildConstant},
                               {"texture", "checker", kChecker, buildChecker},
                               {"texture", "textmap", kTextmap, buildTextmap},
                               {"texture", "image_texture", kTextmap, buildTextmap},
                               {"texture", "bitmap", kTextmap, buildTextmap}};
  rules.insert(rules.end(), std::begin(others), std::end(others));
  return rules;
}

}  // namespace

std::span<const ObjectRule> objectRules() {
  static const std::vector<ObjectRule> rules = makeRules();
  return rules;
}

}  // namespace laver::xml
