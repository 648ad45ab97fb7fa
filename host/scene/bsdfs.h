#pragma once
#include <glm/glm.hpp>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/property.h"
#include "scene/rows.h"
#include "scene/textures.h"

namespace laver {

namespace reference {
struct BsdfPoint;
struct BsdfSample;
}  // namespace reference

/// A BSDF. Its GLSL is shaders/bsdf/NAME.glsl. Directions point away from the surface: wi to where
/// the light goes, wo to where it comes from.
struct BsdfRow {
  const char* name;                       ///< in scenes
  std::vector<const char*> spellings{};   ///< other names in scenes
  const char* object = "";                ///< Nori's class, in the dump
  std::vector<PropertyRow> properties{};  ///< at most one colour and four floats
  bool delta = false;                     ///< a delta distribution: eval and pdf are 0
  /// The value of the BSDF for two unit directions.
  glm::dvec3 (*eval)(const reference::BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) = nullptr;
  /// Density per solid angle of the directions of sample().
  double (*pdf)(const reference::BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) = nullptr;
  /// Samples a direction from two numbers in [0, 1).
  reference::BsdfSample (*sample)(const reference::BsdfPoint& point, glm::dvec3 wi,
                                  glm::dvec2 numbers) = nullptr;
};

namespace bsdfs {
/// The default of meshes without a BSDF.
extern const BsdfRow diffuse;
}  // namespace bsdfs

const Rows<BsdfRow>& bsdfRows();

/// A BSDF from a user's GLSL file, shared by all meshes that name it. The reference cannot evaluate
/// it. Its properties are those that any of the meshes sets, 0 in meshes that do not.
struct UserBsdf {
  std::string name, file, text;
  std::list<std::string> names;  ///< of the properties: the row points to them
  BsdfRow row;
};

/// Reads a file; null if it cannot be read.
std::shared_ptr<UserBsdf> userBsdf(const std::string& file);

/// The BSDF of a mesh with its properties.
struct Bsdf {
  const BsdfRow* row = &bsdfs::diffuse;
  glm::dvec3 albedo{0.5};                  ///< its colour property; white if the row has none
  std::optional<Texture> texture;          ///< replaces the colour
  Values values{};                         ///< floats that differ from the row's defaults
  std::shared_ptr<const UserBsdf> user{};  ///< if the BSDF is from a user's file

  double real(std::string_view property) const {
    return std::get<double>(valueOf(row->properties, values, property));
  }
};

/// The floats of a BSDF in the order of its row.
std::vector<double> numbersOf(const Bsdf& bsdf);

}  // namespace laver
