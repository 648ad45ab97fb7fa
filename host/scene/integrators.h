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

/// What an integrator reads. Nothing else is uploaded for it or computed in its kernel.
struct Needs {
  bool normals = false;     ///< vertex normals
  bool materials = false;   ///< BSDFs and their textures
  bool lights = false;      ///< point lights
  bool emitters = false;    ///< light sources of all kinds
  bool background = false;  ///< the radiance of rays that hit nothing
  bool numbers = false;     ///< random numbers besides the film position
  bool negative = false;    ///< its values may be negative
};

/// What an integrator shows where a camera ray hits nothing. Pixels that can only show black are
/// skipped.
enum class Miss {
  Unknown,  ///< no pixel is skipped
  Black,
  Background  ///< of the scene; black where it has none
};

/// An integrator. Its kernel is shaders/integrators/NAME.glsl.
struct IntegratorRow {
  const char* name;                      ///< in scenes and on the command line
  std::vector<const char*> spellings{};  ///< other names in scenes
  const char* object =
      nullptr;  ///< Nori's class, in the dump; nullptr: a layer, which no scene names
  std::vector<PropertyRow> properties{};
  Needs needs{};
  Miss miss = Miss::Unknown;
  bool litOnly = false;  ///< surfaces are black in a scene without lights
  bool bounces = false;  ///< its rays go on from surfaces, in directions that they do not share
  /// Radiance along a camera ray in double precision, misses included.
  glm::dvec3 (*radiance)(const reference::CameraSample& sample) = nullptr;
};

namespace integrators {
/// Those that other code names.
extern const IntegratorRow normals, directWhitted, depth, averageVisibility, ambientOcclusion,
    shadingNormal, albedo;
}  // namespace integrators

/// All that scenes may name.
const Rows<IntegratorRow>& integratorRows();

struct UserIntegrator;

/// An integrator and its properties.
struct IntegratorUse {
  const IntegratorRow* row = &integrators::normals;
  Values values{};  ///< those that differ from the row's; of a user's own integrator, all
  std::shared_ptr<const UserIntegrator> user{};  ///< an integrator in a file of the user's own

  double real(std::string_view property) const {
    return std::get<double>(valueOf(row->properties, values, property));
  }
  void set(std::string_view property, Value value) { setValue(values, property, std::move(value)); }
  bool is(const IntegratorRow& other) const { return row == &other; }
  /// The same integrator, whatever its properties.
  bool operator==(const IntegratorUse& other) const;
};

/// An integrator in a GLSL file of the user's own. Nothing is known of it: it is given all that a
/// scene has, and no pixel is skipped.
struct UserIntegrator {
  std::string name, file, text;
  IntegratorRow row;
};

/// Reads one. Nothing where the file cannot be read.
std::optional<IntegratorUse> userIntegrator(const std::string& file);

/// Whether what an integrator shows depends on materials, lights or the background.
inline bool shades(const IntegratorRow& row) {
  return row.needs.materials || row.needs.lights || row.needs.emitters || row.needs.background;
}

}  // namespace laver
