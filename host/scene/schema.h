#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "scene/value.h"

namespace laver::xml {

class Properties;

/// A mesh whose file is yet to be read.
struct MeshDraft {
  std::size_t offset;  ///< of the mesh's tag
  std::string filename;
  glm::dmat4 toWorld{1.0};
  Bsdf bsdf;
  std::size_t textureOffset = 0;  ///< of its texture's tag
  std::optional<Sphere> sphere;   ///< then there is no file
  std::optional<AreaLight> light{};
  std::size_t lightOffset = 0;  ///< of its emitter's tag
};

/// A scene while it is read.
struct Draft {
  const SceneOverrides& overrides;
  Scene scene;
  std::vector<MeshDraft> meshes;
  std::vector<PointLight> meshLights;  ///< they come after the scene's own
  std::size_t environmentOffset = 0;   ///< of its tag
  std::map<std::string, std::shared_ptr<UserBsdf>> userBsdfs{};  ///< by file
};

/// An object that laver has: what it takes and what it does to the scene. `parent` is the tag that
/// the object stands in.
struct ObjectRule {
  const char* tag;
  const char* type;
  std::span<const PropertyRow> properties;
  std::function<void(const Properties& given, std::string_view parent, Draft& draft)> build;
  bool spelling = false;  ///< another name of a row
};

/// Puts an integrator that the file names into the scene, unless the command line names another.
void takeIntegrator(const IntegratorUse& use, Draft& draft);
/// Gives the last mesh a BSDF with what the file says of it. `user` holds the row of a user's own.
void takeBsdf(const BsdfRow& row, const std::shared_ptr<const UserBsdf>& user,
              const Properties& given, Draft& draft);

/// Which integrators cannot do without an object.
enum class Need {
  Always,   ///< all: geometry, camera, sampling
  Shading,  ///< those that look at materials and lights
  Never
};

/// A tag that names an object, and where it may stand.
struct TagRule {
  const char* tag;
  Need need;
  const char* parents;  ///< tags with a space behind each; empty: anywhere
  bool many;            ///< more than one may stand in a scene; elsewhere one at most
};

std::span<const ObjectRule> objectRules();
std::span<const TagRule> tagRules();

/// An attribute of a transform's operation: so many numbers.
struct OperationAttribute {
  const char* name;
  std::size_t numbers;
};

/// An operation of a transform. All its attributes are required.
struct OperationRule {
  const char* tag;
  std::span<const OperationAttribute> attributes;
};

std::span<const OperationRule> operationRules();
const OperationRule* findOperation(std::string_view tag);

const TagRule* findTag(std::string_view tag);
const ObjectRule* findObject(std::string_view tag, std::string_view type);
std::span<const PropertyType> propertyTypes();
/// The property type whose tag this is.
const PropertyType* findPropertyType(std::string_view tag);

/// Types that laver has of an object, in the table's order, other spellings left out.
std::vector<std::string_view> knownTypes(std::string_view tag);
/// Names of the operations of a transform.
std::vector<std::string_view> knownOperations();
/// All tags: objects, properties and transform operations.
std::vector<std::string_view> knownTags();

/// Whether something that is rendered of the scene depends on materials, lights or the background.
bool needsShading(const Draft& draft);

}  // namespace laver::xml
