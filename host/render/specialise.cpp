#include "render/specialise.h"

#include <algorithm>
#include <cmath>

#include "render/sampler_data.h"
#include "render/texture_data.h"

namespace laver {
namespace {

/// Entries that suffice for meshes of tens of thousands to a million triangles (48 to 63).
constexpr std::uint32_t kLikelyStack = shared::PLAIN[shared::SPEC_STACK];

/// The stack never holds more subtrees than there are triangles.
std::uint32_t likelyStack(const Scene& scene) {
  return static_cast<std::uint32_t>(
      std::clamp<std::uint64_t>((primitivesOf(scene) + 7) / 8 * 8, 8, kLikelyStack));
}

std::uint32_t samplerConstant(const SamplerRow* row) {
  if (row == &samplers::stratified) return shared::SAMPLER_STRATIFIED;
  return row == &samplers::sobol ? shared::SAMPLER_SOBOL : shared::SAMPLER_INDEPENDENT;
}

}  // namespace

std::uint32_t filterConstant(const Filter& filter) {
  if (filter.row == &filters::gaussian) {
    // exp(alpha * apron) and its inverse stay far from the range of floats.
    const double alpha = 0.5 / (filter.stddev * filter.stddev);
    const std::uint32_t apron = apronOf(filter.radius);
    return apron <= 8 && alpha * apron <= 60.0 ? shared::FILTER_GAUSSIAN_NARROW
                                               : shared::FILTER_GAUSSIAN;
  }
  if (filter.row == &filters::mitchell) return shared::FILTER_MITCHELL;
  return filter.row == &filters::tent ? shared::FILTER_TENT : shared::FILTER_BOX;
}

SpecConstants specialise(const Scene& scene, const RenderOptions& options) {
  return specialise(scene, *scene.integrator.row, options);
}

SpecConstants specialise(const Scene& scene, const IntegratorRow& shown,
                         const RenderOptions& options) {
  const auto& meshes = scene.meshes;
  const bool shaded = shown.needs.lights;
  // Without a light nothing that is hit shows; a background shows where nothing is.
  const bool surfaces = !shaded || !scene.lights.empty();
  const bool hits = surfaces || scene.environment;
  const bool normals =
      surfaces && shown.needs.normals &&
      std::any_of(meshes.begin(), meshes.end(), [](const Mesh& m) { return !m.normals.empty(); });
  const bool albedos =
      shown.needs.materials && surfaces &&
      std::any_of(meshes.begin(), meshes.end(), [&](const Mesh& m) {
        return m.bsdf.albedo != meshes.front().bsdf.albedo || (m.bsdf.texture && meshes.size() > 1);
      });
  SpecConstants constants{};
  constants[shared::SPEC_STACK] = likelyStack(scene);
  constants[shared::SPEC_NORMALS] = normals ? 1 : 0;
  constants[shared::SPEC_ALBEDOS] = albedos ? 1 : 0;
  constants[shared::SPEC_LIGHTS] = !shaded || scene.lights.empty() ? shared::LIGHTS_NONE
                                   : scene.lights.size() <= shared::LIGHTS_A_DISPATCH
                                       ? shared::LIGHTS_FEW
                                       : shared::LIGHTS_MANY;
  constants[shared::SPEC_SAMPLER] = samplerConstant(scene.sampler.row);
  if (scene.sampler.row->stream)
    constants[shared::SPEC_JUMP_LEVELS] = jumpLevels(scene.sampler.sampleCount);
  constants[shared::SPEC_FILTER] = filterConstant(scene.filter);
  constants[shared::SPEC_APRON] = apronOf(scene.filter.radius);
  constants[shared::SPEC_NORI_TABLE] = options.noriCompat ? 1 : 0;
  constants[shared::SPEC_ADAPTIVE] = options.error > 0.0 ? 1 : 0;
  specialiseTextures(scene, shown, constants);
  constants[shared::SPEC_HITS] = hits ? 1 : 0;
  constants[shared::SPEC_DARK_SIDES] = 0;
  constants[shared::SPEC_INDEX_BYTES] = indexBytes(scene, normals);
  constants[shared::SPEC_SPHERES] = hits && hasSpheres(scene) ? 1 : 0;
  return constants;
}

std::uint32_t indexBytes(const Scene& scene, bool normals) {
  // Normal 0 is NO_NORMAL.
  std::uint64_t last = scene.meshes.size();
  std::uint64_t vertexNormals = 0;
  for (const Mesh& mesh : scene.meshes) vertexNormals += mesh.normals.size();
  if (normals) last = std::max(last, vertexNormals);
  return last <= 0xff ? 1 : last <= 0xffff ? 2 : 4;
}

SpecConstants generalise(SpecConstants constants, std::uint32_t which) {
  SpecConstants any = constants;
  any[shared::SPEC_STACK] = std::max(kLikelyStack, constants[shared::SPEC_STACK]);
  any[shared::SPEC_NORMALS] = any[shared::SPEC_ALBEDOS] = 1;
  any[shared::SPEC_LIGHTS] = shared::LIGHTS_MANY;
  if (constants[shared::SPEC_SAMPLER] == shared::SAMPLER_INDEPENDENT)
    any[shared::SPEC_JUMP_LEVELS] = 3;
  any[shared::SPEC_FILTER] = shared::FILTER_AT_RUN_TIME;
  // The widest that the faster gathering kernel takes.
  any[shared::SPEC_APRON] = std::max(4U, constants[shared::SPEC_APRON]);
  any[shared::SPEC_TEXTURES] = shared::TEXTURES_CHECKER | shared::TEXTURES_IMAGE;
  any[shared::SPEC_IMAGES] = shared::IMAGES_BYTES | shared::IMAGES_FLOATS;
  any[shared::SPEC_BACKGROUND] = shared::BACKGROUND_IMAGE;
  any[shared::SPEC_HITS] = any[shared::SPEC_DARK_SIDES] = 1;
  any[shared::SPEC_INDEX_BYTES] = 4;
  any[shared::SPEC_SPHERES] = 1;
  for (std::uint32_t c = 0; c < constants.size(); ++c)
    if ((which >> c & 1U) != 0) constants[c] = any[c];
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
