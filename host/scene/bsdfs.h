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

/// A BSDF. Its kernel's part is shaders/bsdf/NAME.glsl. Directions point away from the surface: wi
/// to where the light goes, wo to where it comes from.
struct BsdfRow {
  const char* name;                       ///< in scenes
  std::vector<const char*> spellings{};   ///< other names in scenes
  const char* object = "";                ///< Nori's class, in the dump
  std::vector<PropertyRow> properties{};  ///< one colour at most, and up to four floats
  bool delta = false;                     ///< reflects in single directions: eval and pdf are 0
  /// The BSDF for two unit directions.
  glm::dvec3 (*eval)(const reference::BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) = nullptr;
  /// Density of sample()'s directions per solid angle.
  double (*pdf)(const reference::BsdfPoint& point, glm::dvec3 wi, glm::dvec3 wo) = nullptr;
  /// Draws a direction by two numbers in [0, 1).
  reference::BsdfSample (*sample)(const reference::BsdfPoint& point, glm::dvec3 wi,
                                  glm::dvec2 numbers) = nullptr;
};

namespace bsdfs {
/// What meshes have that say nothing.
extern const BsdfRow diffuse;
}  // namespace bsdfs

const Rows<BsdfRow>& bsdfRows();

/// A BSDF in a GLSL file of the user's own, one for all meshes that name it. It has no twin; its
/// properties are those that any of the meshes gives, 0 where another gives none.
struct UserBsdf {
  std::string name, file, text;
  std::list<std::string> names;  ///< of the properties: the row points to them
  BsdfRow row;
};

/// Reads one. Nothing where the file cannot be read.
std::shared_ptr<UserBsdf> userBsdf(const std::string& file);

/// What a mesh is made of.
struct Bsdf {
  const BsdfRow* row = &bsdfs::diffuse;
  glm::dvec3 albedo{0.5};                  ///< its colour property; white where the row has none
  std::optional<Texture> texture;          ///< stands for the colour
  Values values{};                         ///< its floats, where they differ from the row's
  std::shared_ptr<const UserBsdf> user{};  ///< a BSDF in a file of the user's own

  double real(std::string_view property) const {
    return std::get<double>(valueOf(row->properties, values, property));
  }
};

/// The floats of a BSDF in the order of its row.
std::vector<double> numbersOf(const Bsdf& bsdf);

}  // namespace laver
