#pragma once
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/property.h"
#include "scene/rows.h"

namespace laver {

namespace reference {
struct CameraSample;
}

/// The data that an integrator needs. Nothing else is uploaded for it or computed in its kernel.
struct Needs {
  bool normals = false;     ///< vertex normals
  bool materials = false;   ///< BSDFs and their textures
  bool lights = false;      ///< point lights
  bool emitters = false;    ///< light sources of all kinds
  bool background = false;  ///< the radiance of rays that hit nothing
  bool numbers = false;     ///< random numbers besides the film position
  bool negative = false;    ///< its values may be negative
};

/// The value of an integrator where a camera ray hits nothing. Pixels that are certainly black are
/// skipped.
enum class Miss {
  Unknown,  ///< no pixel is skipped
  Black,
  Background  ///< that of the scene, or black
};

/// An integrator. Its kernel is shaders/integrators/NAME.glsl.
struct IntegratorRow {
  const char* name;                      ///< in scenes and on the command line
  std::vector<const char*> spellings{};  ///< other names in scenes
  const char* object = nullptr;          ///< Nori's class, in the dump; nullptr: for layers only
  std::vector<PropertyRow> properties{};
  Needs needs{};
  Miss miss = Miss::Unknown;
  bool litOnly = false;   ///< surfaces are black in a scene without lights
  bool looksOn = false;   ///< depends on more than the first hit, though on no light or number
  bool bounces = false;   ///< its rays continue from surfaces, in directions that they do not share
  const char* note = "";  ///< a warning where a scene names it
  /// Radiance along a camera ray in double precision, including misses.
  glm::dvec3 (*radiance)(const reference::CameraSample& sample) = nullptr;
};

namespace integrators {
/// Rows that other code refers to.
extern const IntegratorRow normals, directWhitted, depth, averageVisibility, ambientOcclusion,
    shadingNormal, albedo;
}  // namespace integrators

/// The integrators that scenes can name.
const Rows<IntegratorRow>& integratorRows();

struct UserIntegrator;

/// An integrator and its properties.
struct IntegratorUse {
  const IntegratorRow* row = &integrators::normals;
  Values values{};  ///< that differ from the row's defaults; all of a user's integrator
  std::shared_ptr<const UserIntegrator> user{};  ///< if the integrator is from a user's file

  /// Of a Float or an Integer.
  double real(std::string_view property) const {
    const Value& value = valueOf(row->properties, values, property);
    const auto* integer = std::get_if<std::int64_t>(&value);
    return integer != nullptr ? static_cast<double>(*integer) : std::get<double>(value);
  }
  /// Of a Point or a Color.
  glm::dvec3 triple(std::string_view property) const {
    return std::get<glm::dvec3>(valueOf(row->properties, values, property));
  }
  void set(std::string_view property, Value value) { setValue(values, property, std::move(value)); }
  bool is(const IntegratorRow& other) const { return row == &other; }
  /// Compares the integrators, not their properties.
  bool operator==(const IntegratorUse& other) const;
};

/// An integrator from a user's GLSL file. Its needs are unknown, so it gets everything that a scene
/// has, and no pixel is skipped.
struct UserIntegrator {
  std::string name, file, text;
  IntegratorRow row;
};

/// Reads a file; nothing if it cannot be read.
std::optional<IntegratorUse> userIntegrator(const std::string& file);

/// Whether an integrator's result depends on materials, lights or the background.
inline bool shades(const IntegratorRow& row) {
  return row.needs.materials || row.needs.lights || row.needs.emitters || row.needs.background;
}

}  // namespace laver
