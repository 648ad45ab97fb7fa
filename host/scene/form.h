#pragma once
#include <string_view>
#include <vector>

#include "scene/property.h"

namespace laver {

namespace xml {
class Properties;
struct Draft;
}  // namespace xml

/// One way in which scenes write an object, of which courses may have several.
struct Form {
  const char* type;
  std::vector<PropertyRow> properties{};
  /// Adds the object to the scene. `parent` is the tag that it stands in.
  void (*build)(const xml::Properties& given, std::string_view parent, xml::Draft& draft) = nullptr;
};

}  // namespace laver
