// The objects that scenes can name: one rule per name of each table row.
#include <fmt/format.h>

#include <cmath>

#include "scene/properties.h"
#include "scene/schema.h"
#include "scene/suggest.h"

namespace laver::xml {
namespace {

using Build = void (*)(const Properties& given, std::string_view parent, Draft& draft);

/// The row of an object's type.
template <class Row>
const Row& rowOf(const Properties& given, const Rows<Row>& rows) {
  return *rowCalled(rows, given.rule().type);
}

void buildIntegrator(const Properties& given, std::string_view, Draft& draft) {
  const IntegratorRow& row = rowOf(given, integratorRows());
  IntegratorUse use{&row, given.values()};
  const double length = draft.overrides.dialect->occlusionLength;
  if (use.is(integrators::ambientOcclusion) && use.values.empty() && length > 0.0)
    use.set("length", length);
  if (*row.note != '\0') given.note(fmt::format("{} is {}", nameOf(given.rule()), row.note));
  takeIntegrator(use, draft);
}

// Warns of long strata, which leave one axis nearly random.
void checkStrata(const Properties& given, std::uint32_t count) {
  const glm::uvec2 strata = strataOf(count);
  if (strata.y <= 2 * strata.x) return;
  const auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(count)));
  given.warning(
      "sampleCount",
      fmt::format("{} samples make strata of {} x {} per pixel: {} or {} would make squares", count,
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
  draft.filterOffset = given.offset();
}

void buildBsdf(const Properties& given, std::string_view, Draft& draft) {
  takeBsdf(rowOf(given, bsdfRows()), nullptr, given, draft);
}

template <class Row>
void add(std::vector<ObjectRule>& rules, const char* tag, const Rows<Row>& rows, Build build) {
  for (const Row* row : rows) {
    rules.push_back({tag, row->name, row->properties, build});
    for (const char* spelling : row->spellings)
      rules.push_back({tag, spelling, row->properties, build, true});
  }
}

template <class Row>
void add(std::vector<ObjectRule>& rules, const char* tag, const Rows<Row>& rows) {
  for (const Row* row : rows)
    for (const Form& form : row->forms)
      rules.push_back({tag, form.type, form.properties, form.build});
}

std::vector<ObjectRule> makeRules() {
  std::vector<ObjectRule> rules;
  add(rules, "integrator", integratorRows(), buildIntegrator);
  add(rules, "camera", cameraRows());
  add(rules, "sampler", samplerRows(), buildSampler);
  add(rules, "rfilter", filterRows(), buildFilter);
  add(rules, "mesh", meshRows());
  add(rules, "bsdf", bsdfRows(), buildBsdf);
  add(rules, "emitter", emitterRows());
  add(rules, "texture", textureRows());
  return rules;
}

/// Replaces the name of a material by the values that it stands for. Those that the file gives
/// count more.
void nameMaterial(const Properties& given, Bsdf& bsdf) {
  const std::string* name = nullptr;
  for (const NamedValue& value : bsdf.values)
    if (value.name == "material") name = std::get_if<std::string>(&value.value);
  if (name == nullptr || name->empty()) return;
  if (bsdf.row->ofMaterial != nullptr) bsdf.row = bsdf.row->ofMaterial;
  std::vector<std::string_view> names;
  for (const NamedMaterial& material : bsdf.row->materials) {
    names.emplace_back(material.name);
    if (material.name != *name) continue;
    Values values = material.values;
    for (const NamedValue& own : bsdf.values) setValue(values, own.name, own.value);
    bsdf.values = std::move(values);
    return;
  }
  given.error("material", fmt::format("{} has no material {}: expected {}", nameOf(given.rule()),
                                      inQuotes(*name), expectedNames(*name, names)));
}

}  // namespace

void takeIntegrator(const IntegratorUse& use, Draft& draft) {
  draft.scene.fileIntegrator = use;
  if (!draft.overrides.integrator || *draft.overrides.integrator == use)
    draft.scene.integrator = use;
}

void takeBsdf(const BsdfRow& row, const std::shared_ptr<const UserBsdf>& user,
              const Properties& given, Draft& draft) {
  if (draft.meshes.empty()) return;
  Bsdf& bsdf = draft.meshes.back().bsdf;
  bsdf = {.row = &row, .values = given.values(), .user = user};
  nameMaterial(given, bsdf);
}

std::span<const ObjectRule> objectRules() {
  static const std::vector<ObjectRule> rules = makeRules();
  return rules;
}

}  // namespace laver::xml
