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
class BsdfPoint;
struct BsdfSample;
}  // namespace reference

/// Colours and floats that a BSDF takes.
inline constexpr std::size_t kMostBsdfProperties = 16;

struct BsdfRow;

/// A material that scenes may name in the property `material`, and the values that it stands for.
struct NamedMaterial {
  const char* name;
  Values values;
};

/// A BSDF. Its kernel's part is shaders/bsdf/NAME.glsl. Directions point away from the surface: wi
/// to where the light goes, wo to where it comes from.
struct BsdfRow {
  const char* name;                       ///< in scenes
  std::vector<const char*> spellings{};   ///< other names in scenes
  const char* object = "";                ///< Nori's class, in the dump
  std::vector<PropertyRow> properties{};  ///< textures may stand for colours and floats
  std::vector<NamedMaterial> materials{};
  const BsdfRow* ofMaterial = nullptr;  ///< the BSDF that is meant where a material is named
  bool delta = false;                   ///< reflects in single directions: eval and pdf are 0
  bool transmissive = false;            ///< light goes through
  /// A number that makes it depend on the tangent where it is not 0; or nullptr.
  const char* anisotropy = nullptr;
  /// The BSDF for two unit directions.
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

/// Stands for no property but bends the shading normal, as a normal map.
inline constexpr const char* kNormalMap = "normal map";

/// A texture that stands for a property.
struct NamedTexture {
  std::string property;
  Texture texture;
};

/// What a mesh is made of.
struct Bsdf {
  const BsdfRow* row = &bsdfs::diffuse;
  Values values{};                         ///< where they differ from the row's
  std::vector<NamedTexture> textures{};    ///< one at most for a property
  std::shared_ptr<const UserBsdf> user{};  ///< a BSDF in a file of the user's own

  double real(std::string_view property) const {
    return std::get<double>(valueOf(row->properties, values, property));
  }
  glm::dvec3 color(std::string_view property) const {
    return std::get<glm::dvec3>(valueOf(row->properties, values, property));
  }
  void set(std::string_view property, Value value) { setValue(values, property, std::move(value)); }
  /// The texture that stands for a property, or nullptr.
  const Texture* texture(std::string_view property) const;
  Texture* texture(std::string_view property);
  /// Lets a texture stand for a property.
  void show(std::string_view property, Texture texture);
};

/// Whether a BSDF depends on the tangent of the surface.
bool usesTangent(const Bsdf& bsdf);

/// A row's properties of one type, in its order.
std::vector<const PropertyRow*> propertiesOf(const BsdfRow& row, PropertyType type);
/// The first colour, which the layer `albedo` shows; none: it shows white.
const PropertyRow* albedoOf(const BsdfRow& row);

/// The values of colours and of floats in the order of the row; textures may stand for them.
std::vector<glm::dvec3> colorsOf(const Bsdf& bsdf);
std::vector<double> numbersOf(const Bsdf& bsdf);

}  // namespace laver
