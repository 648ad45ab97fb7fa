#pragma once
#include <optional>

#include "scene/node.h"
#include "scene/properties.h"
#include "scene/schema.h"

namespace laver::xml {

/// Reads the tags of a scene file by the tables of schema.h into a draft.
class Reader {
 public:
  Reader(const TextSource& source, Draft& draft, Diagnostics& diagnostics)
      : source_(source), draft_(draft), diagnostics_(diagnostics) {}

  void readScene(pugi::xml_node root);

 private:
  void readChildren(pugi::xml_node node, Properties* properties, std::string_view parent);
  void readProperty(pugi::xml_node node, PropertyType type, Properties& properties);
  std::optional<Value> readValue(pugi::xml_node node, PropertyType type, const PropertyRow& row);
  void readObject(pugi::xml_node node, const TagRule& rule, const ObjectRule& parent);
  std::string userFilePath(std::string_view type) const;
  bool readUserIntegrator(pugi::xml_node node, const char* type);
  bool readUserBsdf(pugi::xml_node node, const char* type, const ObjectRule& parent);
  void addProperties(pugi::xml_node node, UserBsdf& user);
  void readUnknownTag(pugi::xml_node node, std::string_view parent);
  void checkDialect(pugi::xml_node root);
  void hintAtDialect(pugi::xml_node root);
  bool checkPlace(pugi::xml_node node, const TagRule& rule, std::string_view parent);
  bool checkTexture(pugi::xml_node node, const ObjectRule& parent);
  void missing(pugi::xml_node node, Need need, const std::string& message);
  void checkAreaLights();
  void buildDefault(const char* tag, std::string_view type, std::size_t offset);
  void findIntegrator(pugi::xml_node root);

  std::size_t at(pugi::xml_node node) const { return offsetOf(node, source_); }

  const TextSource& source_;
  Draft& draft_;
  Diagnostics& diagnostics_;
  std::optional<IntegratorUse> integrator_;  // the integrator of the render, if known
};

/// The text of a scene file. Throws Error(Scene).
TextSource sourceOf(const std::string& file);

/// Reads the images and meshes that a draft names.
void loadFiles(const TextSource& source, Draft& draft, Diagnostics& diagnostics);

/// Reads a scene's tags into a draft, whose meshes are not loaded yet.
Draft readDraft(const TextSource& source, const SceneOverrides& overrides,
                Diagnostics& diagnostics);

}  // namespace laver::xml
