#include "reference/light_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/sky_grid.h"
#include "reference/emitter.h"
#include "reference/openness.h"
#include "reference/texture.h"

namespace laver::reference {

namespace {

constexpr double kPi = std::numbers::pi;

double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b; }

/// Flux of a light into its cone, or of a directional one through a disk around the scene.
double powerOf(const PointLight& light, double radius) {
  const double bright = luminance(light.radiance);
  if (light.row == &emitters::directional) return bright * kPi * radius * radius;
  const double half = light.row == &emitters::spot ? 0.5 * glm::radians(light.outer) : 0.5 * kPi;
  return bright * 4.0 * kPi * std::pow(std::sin(half), 2);
}

}  // namespace

glm::dvec3 emitted(const Surface& surface, const glm::dvec3& direction) {
  const std::optional<AreaLight>& light = surface.mesh->light;
  if (!light || glm::dot(surface.shading, direction) <= 0.0) return glm::dvec3(0.0);
  return light->texture ? light->scale * colorOf(*light->texture, surface.textureUv)
                        : light->radiance;
}

LightSources::LightSources(const Scene& scene, const World& world)
    : scene_(&scene), world_(&world) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    add({Source::Kind::Point, i, powerOf(scene.lights[i], 0.5 * world.diagonal()), 0.0});
  if (scene.environment) addBackground();
  addPrimitives();
  distribute();
}

void LightSources::add(const Source& source) {
  if (!(source.power > 0.0)) return;
  sources_.push_back(source);
  power_ += source.power;
}

/// Its power is the flux through a sphere of half the diagonal of the scene.
void LightSources::addBackground() {
  const Environment& sky = *scene_->environment;
  const double radius = 0.5 * world_->diagonal();
  const double factor = luminance(sky.radiance) * kPi * radius * radius;
  background_ = sources_.size();
  if (sky.image) {
    const SkyGrid grid = skyGrid(*sky.image, sky.raw);
    grid_ = grid.size;
    const double least = 1e-9 * *std::max_element(grid.power.begin(), grid.power.end());
    for (std::size_t i = 0; i < grid.power.size(); ++i)
      add({Source::Kind::Background, i, factor * std::max(grid.power[i], least), 0.0});
  } else {
    const double share = std::pow(std::sin(sky.angle * kPi / 360.0), 2);
    add({Source::Kind::Background, 0, factor * share * 4.0 * kPi, 0.0});
  }
  cells_ = sources_.size() - background_;
}

void LightSources::distribute() {
  const double steps = 8388608.0;
  double power = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    power += sources_[i].power;
    const auto after = static_cast<double>(sources_.size() - 1 - i);
    const double least = sum + 1.0, most = steps - after;
    const double next =
        after == 0.0 ? steps : std::min(std::max(std::round(power / power_ * steps), least), most);
    probabilities_.push_back((next - sum) / steps);
    sum = next;
    sums_.push_back(sum / steps);
  }
}

void LightSources::addPrimitives() {
  std::size_t number = 0;
  for (const Mesh& mesh : scene_->meshes) {
    const double flux = mesh.light ? kPi * luminance(mesh.light->radiance) : 0.0;
    if (mesh.sphere && mesh.light) {
      const double area = 4.0 * kPi * mesh.sphere->radius * mesh.sphere->radius;
      add({Source::Kind::Primitive, number, flux * area, area});
    }
    for (std::size_t i = 0; mesh.light && i < mesh.triangles.size(); ++i) {
      const glm::dvec3 a = mesh.positions[mesh.triangles[i].x];
      const double area = 0.5 * glm::length(glm::cross(mesh.positions[mesh.triangles[i].y] - a,
                                                       mesh.positions[mesh.triangles[i].z] - a));
      add({Source::Kind::Primitive, number + i, flux * area, area});
    }
    number += mesh.primitives();
  }
}

SourceSample LightSources::samplePrimitive(const Surface& surface, std::size_t number,
                                           glm::dvec2 point) const {
  const Source& source = sources_[number];
  const Surface light = world_->surfaceOn(static_cast<std::uint32_t>(source.index), point);
  const glm::dvec3 away = light.position - surface.position;
  const double squared = glm::dot(away, away);
  const glm::dvec3 direction = squared > 0.0 ? away / std::sqrt(squared) : surface.shading;
  const double cosine = std::abs(glm::dot(light.geometric, direction));
  SourceSample sample{direction, offsetOrigin(light, -direction), glm::dvec3(0.0), 0.0};
  const glm::dvec3 radiance = emitted(light, -direction);
  if (squared == 0.0 || cosine == 0.0 || radiance == glm::dvec3(0.0)) return sample;
  const double perArea = squared / cosine / source.area;
  sample.density = perArea * (source.power / power_);
  sample.radiance = radiance / (perArea * probabilities_[number]);
  return sample;
}

SourceSample LightSources::sample(const Surface& surface, double number, glm::dvec2 point) const {
  if (sources_.empty()) return {surface.shading, surface.position, glm::dvec3(0.0), 0.0};
  const auto found = std::upper_bound(sums_.begin(), sums_.end(), number);
  const std::size_t place =
      std::min(static_cast<std::size_t>(found - sums_.begin()), sums_.size() - 1);
  const Source& source = sources_[place];
  const double probability = probabilities_[place];
  if (source.kind == Source::Kind::Primitive) return samplePrimitive(surface, place, point);
  if (source.kind == Source::Kind::Background) {
    const Environment& sky = *scene_->environment;
    const DirectionSample drawn = sky.row->direction(sky, grid_, source.index, point);
    const double density = drawn.density * probability;
    return {drawn.direction, surface.position + world_->extent() * drawn.direction,
            sky.row->background(sky, drawn.direction) / density, density};
  }
  const PointLight& light = world_->lights()[source.index];
  const LightSample arriving = light.row->sample(light, surface.position, world_->extent());
  const glm::dvec3 away = arriving.position - surface.position;
  const double distance = glm::length(away);
  return {distance > 0.0 ? away / distance : surface.shading, arriving.position,
          arriving.radiance / probability, 0.0};
}

double LightSources::density(const Surface& met, const glm::dvec3& origin,
                             const glm::dvec3& direction) const {
  if (!met.mesh->light || sums_.empty()) return 0.0;
  const glm::dvec3 away = met.position - origin;
  const double cosine = std::abs(glm::dot(met.geometric, glm::normalize(direction)));
  const double perArea = kPi * luminance(met.mesh->light->radiance) / power_;
  return cosine > 0.0 ? perArea * glm::dot(away, away) / cosine : 0.0;
}

double LightSources::backgroundDensity(const glm::dvec3& direction) const {
  if (cells_ == 0) return 0.0;
  const Environment& sky = *scene_->environment;
  const CellDensity found = sky.row->density(sky, grid_, direction);
  return probabilities_[background_ + found.cell] * found.density;
}

}  // namespace laver::reference
