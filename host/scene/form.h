#pragma once
#include <string_view>
#include <vector>

#include "scene/property.h"

namespace laver {

namespace xml {
class Properties;
struct Draft;
}  // namespace xml

/// One notation of an object in scenes; courses may use several.
struct Form {
  const char* type;
  std::vector<PropertyRow> properties{};
  /// Adds the object to the scene. `parent` is the tag around it.
  void (*build)(const xml::Properties& given, std::string_view parent, xml::Draft& draft) = nullptr;
};

}  // namespace laver
