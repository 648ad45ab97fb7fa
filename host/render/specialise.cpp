#include "render/specialise.h"

#include <algorithm>
#include <cmath>

#include "render/sampler_data.h"
#include "render/texture_data.h"

namespace laver {
namespace {

/// Entries that suffice for meshes of tens of thousands to a million triangles (48 to 63).
constexpr std::uint32_t kLikelyStack = shared::PLAIN[shared::SPEC_STACK];

std::uint32_t filterConstant(const Filter& filter) {
  switch (filter.kind) {
    case Filter::Kind::Gaussian: {
      // exp(alpha * apron) and its inverse stay far from the range of floats.
      const double alpha = 0.5 / (filter.stddev * filter.stddev);
      const std::uint32_t apron = apronOf(filter.radius);
      return apron <= 8 && alpha * apron <= 60.0 ? shared::FILTER_GAUSSIAN_NARROW
                                                 : shared::FILTER_GAUSSIAN;
    }
    case Filter::Kind::Mitchell:
      return shared::FILTER_MITCHELL;
    case Filter::Kind::Tent:
      return shared::FILTER_TENT;
    case Filter::Kind::Box:
      break;
  }
  return shared::FILTER_BOX;
}

std::uint32_t samplerConstant(Sampler::Kind kind) {
  switch (kind) {
    case Sampler::Kind::Stratified:
      return shared::SAMPLER_STRATIFIED;
    case Sampler::Kind::Sobol:
      return shared::SAMPLER_SOBOL;
    case Sampler::Kind::Independent:
      break;
  }
  return shared::SAMPLER_INDEPENDENT;
}

}  // namespace

SpecConstants specialise(const Scene& scene, const RenderOptions& options, bool generic) {
  return specialise(scene, scene.integrator, options, generic);
}

SpecConstants specialise(const Scene& scene, Integrator shown, const RenderOptions& options,
                         bool generic) {
  const auto& meshes = scene.meshes;
  const bool shaded = shown == Integrator::DirectWhitted;
  const bool normals =
      shown != Integrator::Depth && shown != Integrator::Albedo &&
      std::any_of(meshes.begin(), meshes.end(), [](const Mesh& m) { return !m.normals.empty(); });
  const bool coloured = shaded || shown == Integrator::Albedo;
  const bool albedos =
      coloured && std::any_of(meshes.begin(), meshes.end(), [&](const Mesh& m) {
        return m.bsdf.albedo != meshes.front().bsdf.albedo || (m.bsdf.texture && meshes.size() > 1);
      });
  SpecConstants constants{};
  constants[shared::SPEC_STACK] = kLikelyStack;
  constants[shared::SPEC_NORMALS] = normals || generic ? 1 : 0;
  constants[shared::SPEC_ALBEDOS] = albedos || generic ? 1 : 0;
  constants[shared::SPEC_LIGHTS] =
      generic || (shaded && scene.lights.size() > shared::LIGHTS_A_DISPATCH) ? shared::LIGHTS_MANY
      : shaded && !scene.lights.empty()                                      ? shared::LIGHTS_FEW
                                                                             : shared::LIGHTS_NONE;
  constants[shared::SPEC_SAMPLER] = samplerConstant(scene.sampler.kind);
  if (scene.sampler.kind == Sampler::Kind::Independent)
    constants[shared::SPEC_JUMP_LEVELS] = generic ? 3 : jumpLevels(scene.sampler.sampleCount);
  constants[shared::SPEC_FILTER] = filterConstant(scene.filter);
  constants[shared::SPEC_APRON] = apronOf(scene.filter.radius);
  constants[shared::SPEC_NORI_TABLE] = options.noriCompat ? 1 : 0;
  constants[shared::SPEC_ADAPTIVE] = options.error > 0.0 ? 1 : 0;
  specialiseTextures(scene, shown, generic, constants);
  return constants;
}

bool requireStack(SpecConstants& constants, std::uint32_t entries) {
  if (entries <= constants[shared::SPEC_STACK]) return false;
  // Rounded up, so that scenes alike in size share a compiled kernel.
  constants[shared::SPEC_STACK] = (entries + 15) / 16 * 16;
  return true;
}

std::uint32_t apronOf(double radius) {
  return static_cast<std::uint32_t>(std::floor(radius + 0.5));
}

}  // namespace laver
