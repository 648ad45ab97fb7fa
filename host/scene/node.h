#pragma once
#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "scene/diagnostics.h"

namespace laver::xml {

inline bool isElement(pugi::xml_node node) { return node.type() == pugi::node_element; }

/// The byte offset of a tag's name, or of the first visible character of a text.
std::size_t offsetOf(pugi::xml_node node, const TextSource& source);

/// Warns of unknown and of duplicate attributes.
void checkAttributes(pugi::xml_node node, const std::vector<std::string_view>& known,
                     const TextSource& source, Diagnostics& diagnostics);

/// The value of an attribute; if it is missing, reports an error and returns nullptr.
const char* requireAttribute(pugi::xml_node node, const char* name, const TextSource& source,
                             Diagnostics& diagnostics);

/// Parses XML into `document` and returns its root, called `name`. Malformed XML, a missing, second
/// or other root, text outside of tags and tags nested deeper than 64 are errors; then the node is
/// empty.
pugi::xml_node parseDocument(const TextSource& source, pugi::xml_document& document,
                             Diagnostics& diagnostics, std::string_view name = "scene");

}  // namespace laver::xml
