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
  std::map<std::string, std::size_t> textureOffsets;  ///< of textures' tags, by property
  std::optional<Sphere> sphere;                       ///< then there is no file
  std::optional<AreaLight> light{};
  std::size_t lightOffset = 0;     ///< of the emitter's tag
  std::size_t radianceOffset = 0;  ///< of the tag of its texture
  bool isSky = false;              ///< a background takes its place
};

/// A scene that is being read.
struct Draft {
  const SceneOverrides& overrides;
  Scene scene;
  std::vector<MeshDraft> meshes;
  std::vector<PointLight> meshLights;  ///< lights inside of meshes, which follow the scene's own
  std::size_t environmentOffset = 0;   ///< of its tag
  std::size_t filterOffset = 0;        ///< of its tag
  std::map<std::string, std::shared_ptr<UserBsdf>> userBsdfs{};  ///< by file
  bool integratorKnown = false;                                  ///< laver has it
  std::string textured{};      ///< the property that the texture being read stands for
  bool texturedLight = false;  ///< it is one of the last mesh's light
};

/// An object that laver supports: its properties, and the function that adds it to the scene.
/// `parent` is the tag around it.
struct ObjectRule {
  const char* tag;
  const char* type;
  std::span<const PropertyRow> properties;
  std::function<void(const Properties& given, std::string_view parent, Draft& draft)> build;
  bool spelling = false;  ///< another name of a row
};

/// Stores the file's integrator in the scene, unless the command line selects another.
void takeIntegrator(const IntegratorUse& use, Draft& draft);
/// Sets the BSDF of the last mesh from the file's properties. `user` owns the row of a BSDF from a
/// user's file.
void takeBsdf(const BsdfRow& row, const std::shared_ptr<const UserBsdf>& user,
              const Properties& given, Draft& draft);

/// Which integrators need an object.
enum class Need {
  Always,   ///< all: geometry, camera, sampling
  Shading,  ///< those that use materials and lights
  Never
};

/// A tag of an object, and its valid parents.
struct TagRule {
  const char* tag;
  Need need;
  const char* parents;        ///< tags, each followed by a space; empty: any
  bool many;                  ///< a scene may have several; another parent at most one
  const char* spelling = "";  ///< another name of the tag
};

std::span<const ObjectRule> objectRules();
std::span<const TagRule> tagRules();

/// An attribute of a transform's operation, which takes `numbers` numbers.
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
/// The property type of a tag, or nullptr.
const PropertyType* findPropertyType(std::string_view tag);

/// The types of an object that laver supports, in the order of the table, without other spellings.
std::vector<std::string_view> knownTypes(std::string_view tag);
/// Names of the operations of a transform.
std::vector<std::string_view> knownOperations();
/// All tags: objects, properties and transform operations.
std::vector<std::string_view> knownTags();

/// Whether something that is rendered of the scene depends on materials, lights or the background,
/// or may: an integrator that laver lacks hides no other error.
bool needsShading(const Draft& draft);

}  // namespace laver::xml
