#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace laver {

/// Every element, type, property and default that the reader of scenes knows, from its own tables.
/// {"elements": [{"tag", "in": [tags], "many", "neededBy", "types": [{"type", "properties":
/// [{"name", "type", "required", "default"}]}]}], "propertyTypes": [tags],
///  "transform": [{"tag", "attributes": [{"name", "numbers"}]}]}
nlohmann::json schemaJson();

/// The same for people, and as tables of a document.
std::string schemaText();
std::string schemaMarkdown();

}  // namespace laver
