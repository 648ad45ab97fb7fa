// Paths from the camera: the twins of all integrators whose rays bounce.
#include <algorithm>
#include <cmath>

#include "reference/bsdf.h"
#include "reference/integrators.h"
#include "reference/light_sources.h"
#include "reference/openness.h"
#include "reference/texture.h"

namespace laver::reference {

namespace {

struct Rules {
  bool sources = true;        ///< light sampling
  bool bsdf = true;           ///< emission that directions drawn from the BSDF meet counts
  bool emission = true;       ///< that the camera sees
  int bounces = -1;           ///< surfaces that scatter, at most; -1: no maximum
  bool onlyDiscrete = false;  ///< only paths from discrete BSDFs go on
};

/// Russian roulette, from the fourth vertex on.
double survival(const Rules& rules, const glm::dvec3& throughput, int bounce) {
  if (rules.onlyDiscrete) return 0.95;
  return bounce < 3 ? 1.0 : std::min(std::max({throughput.r, throughput.g, throughput.b}), 0.99);
}

double foundWeight(const Rules& rules, double density, double bySources) {
  if (density == 0.0 || !rules.sources) return 1.0;
  return rules.bsdf ? density / (density + bySources) : 0.0;
}

/// Light of one drawn source that the BSDF sends back along the path.
glm::dvec3 fromSources(const CameraSample& sample, const Rules& rules, const BsdfPoint& point,
                       const Surface& surface, const glm::dvec3& wi, double number,
                       glm::dvec2 place) {
  const SourceSample light = sample.sources.sample(surface, number, place);
  if (light.radiance == glm::dvec3(0.0)) return glm::dvec3(0.0);
  const BsdfRow& row = *point.bsdf.row;
  glm::dvec3 value = row.eval(point, wi, light.direction) * light.radiance *
                     std::abs(glm::dot(surface.shading, light.direction));
  if (rules.bsdf && light.density > 0.0)
    value *= light.density / (light.density + row.pdf(point, wi, light.direction));
  if (value == glm::dvec3(0.0)) return value;
  const glm::dvec3 from = offsetOrigin(surface, light.direction);
  return sample.world.blocked(from, light.end) ? glm::dvec3(0.0) : value;
}

/// Surfaces that scatter, at most, by the property; -1: no maximum.
int maximumOf(const CameraSample& sample) {
  const double given = sample.integrator.real("max_depth");
  return given == 0.0 ? -1 : static_cast<int>(given);
}

glm::dvec3 path(const CameraSample& sample, const Rules& rules) {
  glm::dvec3 radiance(0.0), throughput(1.0), direction = sample.direction, origin = sample.origin;
  double density = 0.0;
  bool counts = rules.emission;
  std::optional<WorldHit> hit = sample.hit;
  for (int bounce = 0;; ++bounce) {
    if (!hit) {
      const auto& sky = sample.scene.environment;
      if (sky && counts)
        radiance += throughput * sky->row->background(*sky, direction) *
                    foundWeight(rules, density, sample.sources.backgroundDensity(direction));
      return radiance;
    }
    Surface surface = sample.world.surface(*hit);
    const glm::dvec3 wi = -glm::normalize(direction);
    if (counts)
      radiance += throughput * emitted(surface, wi) *
                  foundWeight(rules, density, sample.sources.density(surface, origin, direction));
    if (bounce == rules.bounces) return radiance;
    surface.shading = bsdfNormal(surface);

    const auto dimension = static_cast<std::uint32_t>(2 + 3 * bounce);
    const glm::dvec2 choices = sample.numbers.pair(dimension);
    const BsdfPoint point(surface.mesh->bsdf, surface.textureUv, surface.shading, surface.tangent);
    if (rules.sources)
      radiance += throughput * fromSources(sample, rules, point, surface, wi, choices.x,
                                           sample.numbers.pair(dimension + 1));
    if (!rules.bsdf && rules.bounces == 1) return radiance;
    const BsdfSample drawn = point.bsdf.row->sample(point, wi, sample.numbers.pair(dimension + 2));
    density = point.bsdf.row->pdf(point, wi, drawn.wo);
    if (drawn.weight == glm::dvec3(0.0) || (rules.onlyDiscrete && density != 0.0)) return radiance;
    throughput *= drawn.weight;
    const double chance = survival(rules, throughput, bounce);
    if (!(choices.y < chance)) return radiance;
    throughput /= chance;
    counts = rules.bsdf || density == 0.0;
    origin = offsetOrigin(surface, drawn.wo);
    direction = drawn.wo;
    hit = sample.world.closestAhead({origin, direction});
  }
}

}  // namespace

glm::dvec3 whitted(const CameraSample& s) { return path(s, {.bsdf = false, .onlyDiscrete = true}); }
glm::dvec3 direct(const CameraSample& s) {
  return path(s, {.bsdf = false, .emission = false, .bounces = 1});
}
glm::dvec3 directEms(const CameraSample& s) { return path(s, {.bsdf = false, .bounces = 1}); }
glm::dvec3 directMats(const CameraSample& s) { return path(s, {.sources = false, .bounces = 1}); }
glm::dvec3 directMis(const CameraSample& s) { return path(s, {.bounces = 1}); }
glm::dvec3 pathEms(const CameraSample& s) {
  return path(s, {.bsdf = false, .bounces = maximumOf(s)});
}
glm::dvec3 pathMats(const CameraSample& s) {
  return path(s, {.sources = false, .bounces = maximumOf(s)});
}
glm::dvec3 pathMis(const CameraSample& s) { return path(s, {.bounces = maximumOf(s)}); }
glm::dvec3 photonMapper(const CameraSample& s) { return path(s, {}); }

}  // namespace laver::reference
