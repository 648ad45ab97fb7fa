#include "reference/light_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/picture.h"
#include "reference/emitter.h"
#include "reference/openness.h"

namespace laver::reference {

namespace {

constexpr double kPi = std::numbers::pi;

double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b; }

/// Flux through a sphere of that radius.
double powerOf(const Environment& environment, double radius) {
  double radiance = luminance(environment.radiance);
  if (environment.image) radiance *= meanLuminance(*environment.image, environment.raw);
  if (environment.row == &emitters::distantdisk)
    radiance *= std::pow(std::sin(environment.angle * kPi / 360.0), 2);
  return radiance * 4.0 * kPi * kPi * radius * radius;
}

}  // namespace

glm::dvec3 emitted(const Surface& surface, const glm::dvec3& direction) {
  const bool seen = surface.mesh->light && glm::dot(surface.shading, direction) > 0.0;
  return seen ? surface.mesh->light->radiance : glm::dvec3(0.0);
}

LightSources::LightSources(const Scene& scene, const World& world)
    : scene_(&scene), world_(&world) {
  for (std::size_t i = 0; i < scene.lights.size(); ++i)
    add({Source::Kind::Point, i, 4.0 * kPi * luminance(scene.lights[i].radiance), 0.0});
  if (scene.environment) {
    backgroundPower_ = powerOf(*scene.environment, 0.25 * world.extent());
    add({Source::Kind::Background, 0, backgroundPower_, 0.0});
  }
  addPrimitives();
}

void LightSources::add(const Source& source) {
  if (!(source.power > 0.0)) return;
  sources_.push_back(source);
  sums_.push_back((sums_.empty() ? 0.0 : sums_.back()) + source.power);
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

SourceSample LightSources::samplePrimitive(const Surface& surface, const Source& source,
                                           glm::dvec2 point) const {
  const Surface light = world_->surfaceOn(static_cast<std::uint32_t>(source.index), point);
  const glm::dvec3 away = light.position - surface.position;
  const double squared = glm::dot(away, away);
  const glm::dvec3 direction = squared > 0.0 ? away / std::sqrt(squared) : surface.shading;
  const double cosine = std::abs(glm::dot(light.geometric, direction));
  SourceSample sample{direction, offsetOrigin(light, -direction), glm::dvec3(0.0), 0.0};
  const glm::dvec3 radiance = emitted(light, -direction);
  if (squared == 0.0 || cosine == 0.0 || radiance == glm::dvec3(0.0)) return sample;
  sample.density = squared / cosine / source.area * (source.power / sums_.back());
  sample.radiance = radiance / sample.density;
  return sample;
}

SourceSample LightSources::sample(const Surface& surface, double number, glm::dvec2 point) const {
  if (sources_.empty()) return {surface.shading, surface.position, glm::dvec3(0.0), 0.0};
  const auto found = std::upper_bound(sums_.begin(), sums_.end(), number * sums_.back());
  const auto place = std::min<std::ptrdiff_t>(found - sums_.begin(),
                                              static_cast<std::ptrdiff_t>(sums_.size()) - 1);
  const Source& source = sources_[static_cast<std::size_t>(place)];
  const double probability = source.power / sums_.back();
  if (source.kind == Source::Kind::Primitive) return samplePrimitive(surface, source, point);
  if (source.kind == Source::Kind::Background) {
    const Environment& sky = *scene_->environment;
    const DirectionSample drawn = sky.row->direction(sky, point);
    const double density = drawn.density * probability;
    return {drawn.direction, surface.position + world_->extent() * drawn.direction,
            sky.row->background(sky, drawn.direction) / density, density};
  }
  const PointLight& light = world_->lights()[source.index];
  const LightSample arriving = light.row->sample(light, surface.position);
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
  const double perArea = kPi * luminance(met.mesh->light->radiance) / sums_.back();
  return cosine > 0.0 ? perArea * glm::dot(away, away) / cosine : 0.0;
}

double LightSources::backgroundDensity(const glm::dvec3& direction) const {
  const auto& sky = scene_->environment;
  if (!sky || !(backgroundPower_ > 0.0)) return 0.0;
  return backgroundPower_ / sums_.back() * sky->row->density(*sky, direction);
}

}  // namespace laver::reference
