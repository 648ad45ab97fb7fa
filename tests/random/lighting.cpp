#include "random/lighting.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "scene/texture_forms.h"

namespace laver::test {
namespace {

using glm::dvec3;

/// Where lights are. Whether a surface blocks a light that is in it, up to the offsets of shadow
/// rays, is a matter of rounding, for which nothing would account at later hits of paths.
dvec3 placeOfLight(const Scene& scene, bool touching, Draw& draw, std::string& traits) {
  const Mesh& mesh = scene.meshes[draw.below(scene.meshes.size())];
  switch (draw.below(8)) {
    case 0: {
      const double distance = draw.scale(10.0, 1e6);
      traits += fmt::format(" {:.2g} away", distance);
      return distance * draw.direction();
    }
    case 1:
      if (!touching) break;
      traits += " on a surface";
      return pointOn(mesh, draw);
    case 2: {
      const double distance = draw.scale(touching ? 1e-7 : 1e-2, 1e-1);
      traits += fmt::format(" {:.2g} from a surface", distance);
      return pointOn(mesh, draw) + distance * draw.direction();
    }
    case 3:
      if (mesh.sphere) {
        traits += " in a sphere";
        return mesh.sphere->centre + 0.9 * mesh.sphere->radius * draw.unit() * draw.direction();
      }
      break;
    default:
      break;
  }
  traits += " near";
  return draw.between(1.0, 5.0) * draw.direction();
}

PointLight randomLight(const Scene& scene, const Kind& kind, bool shaped, Draw& draw,
                       std::string& traits) {
  PointLight light;
  traits += "; light";
  light.position = placeOfLight(scene, kind.explained(), draw, traits);
  // At a unit's distance at least, so that the picture is not white.
  const double distance = std::max(0.1, glm::length(light.position));
  light.radiance = draw.color() * (distance * distance * draw.scale(0.5, 20.0));
  light.axis =
      draw.chance(0.7) ? glm::normalize(-light.position + 0.3 * draw.point()) : draw.direction();
  if (!shaped) return light;
  if (draw.chance(0.3)) {
    light.row = &emitters::directional;
    light.radiance = draw.color() * draw.scale(0.5, 5.0);
    traits += " directional";
  } else if (draw.chance(0.6)) {
    light.row = &emitters::spot;
    light.outer = draw.scale(2.0, 180.0);
    light.inner = draw.chance(0.2) ? light.outer : light.outer * draw.unit();
    constexpr std::array kFalloffs{Falloff::Angle, Falloff::Square, Falloff::Quartic,
                                   Falloff::Projected};
    light.falloff = kFalloffs[draw.below(kFalloffs.size())];
    traits += fmt::format(" spot to {:.2g} degrees", light.outer);
  }
  return light;
}

void addSky(const EmitterRow& row, Scene& scene, Draw& draw, std::string& traits) {
  Environment sky;
  sky.row = &row;
  sky.radiance = draw.color();
  traits += fmt::format("; {} sky", row.name);
  if (&row == &emitters::distantdisk) {
    sky.angle = draw.scale(1e-3, 180.0);
    const dvec3 z = draw.direction();
    const dvec3 x =
        glm::normalize(glm::cross(z, std::abs(z.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    sky.toWorld = glm::dmat4(glm::dmat3(x, glm::cross(z, x), z));
  }
  scene.environment = sky;
}

/// Of the properties of integrators.
void setProperties(const Kind& kind, Scene& scene, Draw& draw) {
  IntegratorUse& integrator = scene.integrator;
  const std::string name = integrator.row->name;
  if (name == "av") integrator.set("length", draw.scale(0.01, 100.0));
  if (name == "ao" && draw.chance(0.5)) integrator.set("length", draw.scale(0.01, 2.0));
  if (name == "simple") {
    std::string unused;
    const PointLight light = randomLight(scene, kind, false, draw, unused);
    integrator.set("position", light.position);
    integrator.set("energy", light.radiance * 40.0);
  }
  if (name.starts_with("path") && draw.chance(0.4))
    integrator.set("max_depth", std::int64_t{draw.integer(1, 5)});
}

}  // namespace

Texture randomTexture(const TextureRow& row, Draw& draw) {
  Texture texture{.row = &row, .colors = {draw.color(), draw.color()}};
  // (u, v) as a colour has neither scale nor offset in scenes, and would be negative.
  if (&row == &textures::uv) return texture;
  texture.scale = {draw.scale(0.5, 8.0), draw.chance(0.2) ? 0.0 : draw.scale(0.5, 8.0)};
  texture.offset = {draw.between(-3.0, 3.0), draw.between(-3.0, 3.0)};
  return texture;
}

dvec3 pointOn(const Mesh& mesh, Draw& draw) {
  if (mesh.sphere) return mesh.sphere->centre + mesh.sphere->radius * draw.direction();
  if (mesh.triangles.empty()) return dvec3(0.0);
  const glm::uvec3 t = mesh.triangles[draw.below(mesh.triangles.size())];
  const double u = draw.unit(), v = draw.unit() * (1.0 - u);
  return (1.0 - u - v) * mesh.positions[t.x] + u * mesh.positions[t.y] + v * mesh.positions[t.z];
}

void addLighting(const Kind& kind, Scene& scene, Draw& draw, std::string& traits) {
  const Needs& needs = kind.integrator->needs;
  if (needs.lights) {
    const int count = draw.chance(0.1) ? draw.integer(9, 20) : draw.integer(1, 3);
    std::string names;
    const bool shaped = draw.chance(0.5);
    for (int i = 0; i < count; ++i)
      scene.lights.push_back(randomLight(scene, kind, shaped, draw, names));
    traits += count > 3 ? fmt::format("; {} lights", count) : names;
  }
  if (needs.background && kind.sky != nullptr) addSky(*kind.sky, scene, draw, traits);
  if (needs.emitters && kind.lamp) {
    AreaLight& lamp =
        scene.meshes[1].light.emplace(AreaLight{draw.color() * draw.scale(0.5, 10.0)});
    traits += "; lamp";
    if (kind.shown != nullptr) {
      lamp.texture = std::make_shared<Texture>(randomTexture(*kind.shown, draw));
      lamp.radiance = kind.shown->mean(*lamp.texture);
      traits += fmt::format(" that shows {}", kind.shown->name);
    }
  }
  setProperties(kind, scene, draw);
}

}  // namespace laver::test
