#include "scene/schema_text.h"

#include <fmt/format.h>

#include <sstream>

#include "scene/schema.h"

namespace laver {
namespace {

using namespace xml;

std::string needOf(const TagRule& rule) {
  if (rule.need == Need::Always) return "every integrator";
  return rule.need == Need::Shading ? "integrators that shade" : "none";
}

nlohmann::json propertyJson(const PropertyRow& rule) {
  nlohmann::json json{{"name", rule.name}, {"type", tagOf(rule.type)}};
  json["required"] = rule.required;
  if (!rule.required) json["default"] = textOf(rule.start);
  return json;
}

nlohmann::json elementJson(const TagRule& tag) {
  nlohmann::json json{{"tag", tag.tag}, {"many", tag.many}, {"neededBy", needOf(tag)}};
  json["in"] = nlohmann::json::array();
  std::istringstream parents(tag.parents);
  for (std::string parent; parents >> parent;) json["in"].push_back(parent);
  if (std::string_view(tag.tag) == "texture") json["in"] = {"bsdf"};  // Reader::checkTexture
  json["types"] = nlohmann::json::array();
  for (const ObjectRule& object : objectRules()) {
    if (object.tag != std::string_view(tag.tag)) continue;
    nlohmann::json properties = nlohmann::json::array();
    for (const PropertyRow& property : object.properties)
      properties.push_back(propertyJson(property));
    json["types"].push_back({{"type", object.type}, {"properties", properties}});
  }
  return json;
}

/// The default as text, in words if the value has no text.
std::string startText(const PropertyRow& row) {
  if (row.required) return "required";
  const std::string text = textOf(row.start);
  if (row.pair) return text.substr(0, text.rfind(' '));
  if (!text.empty()) return text;
  return row.type == PropertyType::Transform ? "identity" : "none";
}

std::string propertyLine(const PropertyRow& row) {
  return fmt::format("    {:<12} {:<10} {}\n", row.name, tagOf(row.type), startText(row));
}

std::string elementText(const nlohmann::json& element) {
  std::string places;
  for (const std::string place : element["in"])
    places += fmt::format("{}<{}>", places.empty() ? "in " : " or ", place);
  std::string text =
      fmt::format("<{} type=\"...\">  {}, {}; needed by {}\n", element["tag"].get<std::string>(),
                  places.empty() ? "anywhere" : places, element["many"] ? "any number" : "one",
                  element["neededBy"].get<std::string>());
  if (element["types"].empty()) text += "  laver has no type of it\n";
  for (const ObjectRule& object : objectRules()) {
    if (object.tag != element["tag"].get<std::string>()) continue;
    text += fmt::format("  {}\n", object.type);
    for (const PropertyRow& row : object.properties) text += propertyLine(row);
  }
  return text + '\n';
}

}  // namespace

nlohmann::json schemaJson() {
  nlohmann::json json;
  json["propertyTypes"] = nlohmann::json::array();
  for (const PropertyType type : propertyTypes()) json["propertyTypes"].push_back(tagOf(type));
  json["elements"] = nlohmann::json::array();
  for (const TagRule& tag : tagRules()) json["elements"].push_back(elementJson(tag));
  json["transform"] = nlohmann::json::array();
  for (const OperationRule& operation : operationRules()) {
    nlohmann::json attributes = nlohmann::json::array();
    for (const OperationAttribute& attribute : operation.attributes)
      attributes.push_back({{"name", attribute.name}, {"numbers", attribute.numbers}});
    json["transform"].push_back({{"tag", operation.tag}, {"attributes", attributes}});
  }
  return json;
}

std::string schemaText() {
  const nlohmann::json json = schemaJson();
  std::string text =
      "The objects of a <scene>. Below each type are its properties, <TYPE name=\"NAME\" "
      "value=\"...\"/>, as\nNAME TYPE DEFAULT.\n\n";
  for (const auto& element : json["elements"]) text += elementText(element);
  text += "<transform name=\"NAME\">  holds operations; the first written applies first\n";
  for (const auto& operation : json["transform"]) {
    text += fmt::format("  <{}", operation["tag"].get<std::string>());
    for (const auto& attribute : operation["attributes"]) {
      const auto count = attribute["numbers"].get<std::size_t>();
      text += fmt::format(" {}=\"{} number{}\"", attribute["name"].get<std::string>(), count,
                          count == 1 ? "" : "s");
    }
    text += "/>\n";
  }
  return text;
}

std::string schemaMarkdown() {
  std::string text;
  for (const TagRule& tag : tagRules()) {
    std::string rows;
    for (const ObjectRule& object : objectRules()) {
      if (object.tag != std::string_view(tag.tag)) continue;
      if (object.properties.empty()) rows += fmt::format("| `{}` | | | | |\n", object.type);
      for (const PropertyRow& p : object.properties) {
        rows += fmt::format("| `{}` | `{}` {} | {} | {} | {} |\n", object.type, p.name,
                            tagOf(p.type), startText(p), rangeText(p), p.meaning);
      }
    }
    if (rows.empty()) continue;
    text += fmt::format(
        "### `<{}>`\n\n| type | property | default | range | meaning |\n"
        "|---|---|---|---|---|\n{}\n",
        tag.tag, rows);
  }
  return text;
}

}  // namespace laver
