// The light sources of light sampling.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.h"
#include "image/sky_grid.h"
#include "render/pack_parts.h"

namespace laver {
namespace {

using glm::dvec3;
using glm::vec3;

/// Random numbers are multiples of 2^-23 (unitFloat()), and so are the sums of probabilities.
constexpr double kSteps = 0x1p23;

struct Weighed {
  shared::Source source;
  double power;
};

double luminance(const dvec3& rgb) { return glm::dot(rgb, dvec3(0.2126, 0.7152, 0.0722)); }

double areaOf(const shared::Triangle& t) {
  if (t.flipped == shared::IS_CAP)
    return 4.0 * std::numbers::pi / (static_cast<double>(t.c.x) * static_cast<double>(t.c.x));
  if (t.flipped == shared::IS_SPHERE) return 4.0 * std::numbers::pi * double{t.b.x} * double{t.b.x};
  return 0.5 * glm::length(glm::cross(dvec3(t.b) - dvec3(t.a), dvec3(t.c) - dvec3(t.a)));
}

/// Luminance times solid angle of the background, cell by cell of an image.
SkyGrid gridOf(const Environment& environment) {
  const double all = luminance(environment.radiance);
  const double versine = 2.0 * std::pow(std::sin(0.5 * glm::radians(environment.angle)), 2);
  if (!environment.image) return {glm::ivec2(1), {all * 2.0 * std::numbers::pi * versine}};
  SkyGrid grid = skyGrid(*environment.image, environment.raw);
  double brightest = 0.0;
  for (double& power : grid.power) brightest = std::max(brightest, power *= all);
  // Each cell keeps its place in the list, as a source that is drawn.
  for (double& power : grid.power) power = std::max(power, brightest * 1e-9);
  return grid;
}

/// The sources of the background. The power is the flux through a sphere around the scene, of half
/// its box's diagonal.
void addBackground(const Scene& scene, Packed& packed, std::vector<Weighed>& all) {
  const SkyGrid grid = gridOf(*scene.environment);
  const double radius = 0.5 * packed.diagonal * packed.space.scale;
  shared::Params& p = packed.params;
  p.backgroundCells = glm::uvec2(grid.size);
  const glm::dmat3 rows(p.backgroundX, p.backgroundY, p.backgroundZ);
  p.cellDensity =
      static_cast<float>(std::abs(glm::determinant(rows)) * grid.size.x /
                         (4.0 * std::numbers::pi * std::sin(0.5 * std::numbers::pi / grid.size.y)));
  for (std::uint32_t i = 0; i < grid.power.size(); ++i)
    all.push_back({{shared::SOURCE_BACKGROUND, i, 0.0F, 0.0F},
                   grid.power[i] * std::numbers::pi * radius * radius});
}

/// The mesh that each slot's primitive belongs to.
std::vector<std::uint32_t> meshesOf(const Scene& scene, const Packed& packed) {
  std::vector<std::uint64_t> ends;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < scene.meshes.size(); ++i)
    ends.push_back(count += packed.isSplit(i) ? packed.splits[i]->pieces.size()
                                              : scene.meshes[i].primitives());
  std::vector<std::uint32_t> meshes;
  for (const shared::Triangle& t : packed.bvh.triangles)
    meshes.push_back(static_cast<std::uint32_t>(
        std::upper_bound(ends.begin(), ends.end(), std::uint64_t{t.id}) - ends.begin()));
  return meshes;
}

/// Primitives of meshes that emit, in file order. Triangles of meshes that were split are sources
/// as wholes, which stand behind the caps.
std::vector<Weighed> primitives(const Scene& scene, const Packed& packed) {
  const Bvh& bvh = packed.bvh;
  const std::vector<std::uint32_t> meshes = meshesOf(scene, packed);
  const std::uint32_t wholes = packed.params.firstCap + packed.params.capCount;
  std::vector<std::uint32_t> slots;
  for (std::uint32_t slot = 0; slot < meshes.size(); ++slot)
    if (scene.meshes[meshes[slot]].light && packed.isSplit(meshes[slot]) == (slot >= wholes))
      slots.push_back(slot);
  std::sort(slots.begin(), slots.end(), [&](std::uint32_t a, std::uint32_t b) {
    return bvh.triangles[a].id < bvh.triangles[b].id;
  });
  std::vector<Weighed> all;
  for (const std::uint32_t slot : slots)
    all.push_back({{shared::SOURCE_PRIMITIVE, slot, 0.0F, 0.0F},
                   std::numbers::pi * luminance(scene.meshes[meshes[slot]].light->radiance) *
                       areaOf(bvh.triangles[slot])});
  return all;
}

/// Sums of probabilities in multiples of 2^-23, so that each source is drawn exactly as often as
/// its probability says; a source with power has at least one step.
std::vector<shared::Source> distributed(const std::vector<Weighed>& all, double total) {
  if (static_cast<double>(all.size()) > kSteps / 2)
    throw Error(ExitCode::Device,
                "light sampling draws from 4,194,304 light sources at most, "
                "found " +
                    std::to_string(all.size()));
  std::vector<shared::Source> sources;
  double sum = 0.0, upper = 0.0;
  auto left = static_cast<double>(all.size());
  for (const Weighed& weighed : all) {
    sum += weighed.power;
    left -= 1.0;
    const double wanted = std::round(sum / total * kSteps);
    const double next = std::clamp(wanted, upper + 1.0, kSteps - left);
    sources.push_back(weighed.source);
    sources.back().upper = static_cast<float>(next / kSteps);
    sources.back().probability = static_cast<float>((next - upper) / kSteps);
    upper = next;
  }
  if (!sources.empty()) {
    sources.back().probability += static_cast<float>((kSteps - upper) / kSteps);
    sources.back().upper = 1.0F;
  }
  return sources;
}

}  // namespace

void packSources(const Scene& scene, Packed& packed) {
  // Powers are those of device coordinates, where areas are scale^2 times as large.
  const double squared = packed.space.scale * packed.space.scale;
  std::vector<Weighed> all;
  for (std::uint32_t i = 0; i < packed.lights.size(); ++i)
    all.push_back({{shared::SOURCE_POINT, i, 0.0F, 0.0F},
                   squared * powerOf(scene.lights[i], 0.5 * packed.diagonal)});
  if (scene.environment) addBackground(scene, packed, all);
  for (const Weighed& primitive : primitives(scene, packed)) all.push_back(primitive);

  double total = 0.0;
  for (const Weighed& weighed : all) total += weighed.power;
  packed.emission.resize(scene.meshes.size());
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const auto& light = scene.meshes[i].light;
    const dvec3 radiance = light ? light->radiance : dvec3(0.0);
    const double density = total > 0.0 ? std::numbers::pi * luminance(radiance) / total : 0.0;
    shared::Emission& emission = packed.emission[i];
    const bool textured = emission.shown != shared::TEXTURE_NONE;
    emission.radiance = textured ? vec3(static_cast<float>(light->scale)) : vec3(radiance);
    emission.density = static_cast<float>(density);
  }
  // Sources without power are never drawn.
  std::erase_if(all, [](const Weighed& weighed) { return !(weighed.power > 0.0); });
  packed.sources = distributed(all, total);
  packed.params.sources = static_cast<std::uint32_t>(packed.sources.size());
  const auto sky = std::find_if(
      packed.sources.begin(), packed.sources.end(),
      [](const shared::Source& source) { return source.kind == shared::SOURCE_BACKGROUND; });
  packed.params.backgroundSource = static_cast<std::uint32_t>(sky - packed.sources.begin());
  packed.params.backgroundProbability = sky == packed.sources.end() ? 0.0F : sky->probability;
}

}  // namespace laver
