#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "image/picture.h"
#include "scene/form.h"
#include "scene/rows.h"
#include "scene/textures.h"

namespace laver {

struct PointLight;
struct Environment;

namespace reference {
struct LightSample;
struct DirectionSample;
struct CellDensity;
}  // namespace reference

/// A kind of emitter. Its kernel's part is shaders/emitter/NAME.glsl, its twin in double precision
/// host/reference/emitter/NAME.cpp. Point-like lights have `sample`, a background the other
/// functions. `reach`: longer than the scene.
struct EmitterRow {
  const char* name;
  const char* object = "";  ///< Nori's class, in the dump
  std::vector<Form> forms{};
  /// What the dump shows of a background between radiance and toWorld.
  std::string (*describe)(const Environment& environment) = nullptr;
  reference::LightSample (*sample)(const PointLight& light, const glm::dvec3& from,
                                   double reach) = nullptr;
  /// Background radiance in a direction of any length except 0.
  glm::dvec3 (*background)(const Environment& environment, const glm::dvec3& direction) = nullptr;
  /// Draws a direction to the background from a cell of its grid (SkyGrid), and its density per
  /// solid angle.
  reference::DirectionSample (*direction)(const Environment& environment, glm::ivec2 grid,
                                          std::size_t cell, glm::dvec2 numbers) = nullptr;
  reference::CellDensity (*density)(const Environment& environment, glm::ivec2 grid,
                                    const glm::dvec3& direction) = nullptr;
};

namespace emitters {
extern const EmitterRow point, spot, directional, area, constant, environment, distantdisk;
}  // namespace emitters

const Rows<EmitterRow>& emitterRows();

/// How a spot light's intensity falls from its inner to its outer angle; in the order of
/// LIGHT_SPOT_ in shaders/shared/layout.h.
enum class Falloff {
  Angle,     ///< linearly in the angle
  Square,    ///< as the square of what is linear in the cosine
  Quartic,   ///< as its fourth power
  Projected  ///< the same, times the cosine
};

/// Isotropic point light: radiance / distance^2 arrives at a surface. A spot light sends that along
/// its axis only, a directional light its radiance from infinitely far away.
struct PointLight {
  glm::dvec3 position{0.0, 100.0, 0.0};
  glm::dvec3 radiance{1.0};
  const EmitterRow* row = &emitters::point;
  glm::dvec3 axis{0.0, -1.0, 0.0};  ///< unit; along which the light travels
  double inner = 0.0, outer = 0.0;  ///< degrees from the axis
  Falloff falloff = Falloff::Angle;
};

/// Light that a mesh emits, on the side of its shading normal.
struct AreaLight {
  glm::dvec3 radiance{1.0};  ///< mean radiance, by which light is sampled
  double scale = 1.0;        ///< factor of the texture
  /// Stands for the radiance.
  std::shared_ptr<Texture> texture{};
};

/// What rays that hit nothing see. Of an image, in the space that toWorld takes to the world, the
/// rows go from +y to -y and the columns from -z over +x, +z and -x, as in Mitsuba. Of a disk, the
/// radiance of the directions within `angle` of +z.
struct Environment {
  glm::dvec3 radiance{1.0};  ///< constant radiance, or factor of the image
  glm::dmat4 toWorld{1.0};   ///< only the linear part is used
  std::string filename{};    ///< empty: no image
  bool raw = false;
  bool encoded = false;                    ///< values of an EXR image, too, are divided by 255
  double angle = 180.0;                    ///< degrees; 180: all directions
  std::shared_ptr<const Picture> image{};  ///< null if the integrator does not use the background
  const EmitterRow* row = &emitters::constant;
};

}  // namespace laver
