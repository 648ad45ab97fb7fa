#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace laver {

/// Every element, type, property and default that the scene reader supports, from its own tables:
/// {"elements": [{"tag", "in": [tags], "many", "neededBy", "types": [{"type", "properties":
/// [{"name", "type", "required", "default"}]}]}], "propertyTypes": [tags],
///  "transform": [{"tag", "attributes": [{"name", "numbers"}]}]}
nlohmann::json schemaJson();

/// The same as plain text and as Markdown tables.
std::string schemaText();
std::string schemaMarkdown();

}  // namespace laver
