// The reader accepts exactly what `laver schema` lists.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "scene/schema_text.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

using nlohmann::json;

/// A value of a property: its default, or one of its type.
std::string valueOf(const json& property) {
  static const std::map<std::string, std::string> values = {
      {"string", "t.obj"}, {"boolean", "true"}, {"float", "0.25"},  {"integer", "2"},
      {"vector", "1 2 3"}, {"point", "1 2 3"},  {"color", "1 2 3"},
  };
  return property["required"] ? values.at(property["type"])
                              : property["default"].get<std::string>();
}

std::string xmlOf(const json& property) {
  const std::string type = property["type"], name = property["name"];
  if (type == "transform") return fmt::format("<transform name=\"{}\"/>", name);
  return fmt::format("<{} name=\"{}\" value=\"{}\"/>", type, name, valueOf(property));
}

/// A scene with an object with `properties`, in a place where it is allowed.
std::string sceneOf(const json& element, const std::string& type, const std::string& properties) {
  const std::string tag = element["tag"],
                    place = element["in"].empty() ? "scene" : element["in"][0];
  const std::string object = fmt::format("<{0} type=\"{1}\">{2}</{0}>", tag, type, properties);
  if (tag == "integrator") return "<scene>" + object + "</scene>";
  if (place == "camera") return scene("<camera type=\"perspective\">" + object + "</camera>");
  if (tag == "texture")  // with an integrator that reads no image
    return scene(
        mesh(fmt::format("<bsdf type=\"diffuse\"><texture name=\"albedo\" type=\"{}\">{}"
                         "</texture></bsdf>",
                         type, properties)));
  if (type == "area") return scene(mesh(object), "path_mis");
  // With an integrator that shows backgrounds, the image must exist, and there is a warning.
  const bool background =
      type == "environment" || type == "envmap" || type == "constant" || type == "distantdisk";
  return scene(place == "mesh" ? mesh(object) : object, background ? "normals" : "direct_whitted");
}

std::string requiredOf(const json& type, const json& besides) {
  std::string text;
  for (const json& property : type["properties"])
    if (property["required"] && property != besides) text += xmlOf(property);
  return text;
}

TEST(SceneSchema, TheReaderTakesEveryPropertyListed) {
  const SceneFiles files;
  const SceneOverrides named{.dialectNamed = true};  // no hint at a dialect
  files.write("t.obj", kTriangle);
  int properties = 0;
  const json schema = schemaJson();
  for (const json& element : schema["elements"])
    for (const json& type : element["types"])
      for (const json& property : type["properties"]) {
        SCOPED_TRACE(type["type"].get<std::string>() + " " + property["name"].get<std::string>());
        const std::string rest = requiredOf(type, property);
        const std::string xml = sceneOf(element, type["type"], xmlOf(property) + rest);
        EXPECT_EQ(files.errors(xml), "");
        // Exactly the required properties are required.
        const std::string without = sceneOf(element, type["type"], rest);
        const bool complete = files.errors(without).empty();
        EXPECT_EQ(complete, !property["required"].get<bool>());
        // Some objects warn in any case.
        EXPECT_EQ(files.warnings(xml, named), complete ? files.warnings(without, named) : "");
        ++properties;
      }
  EXPECT_GE(properties, 20);
}

TEST(SceneSchema, AnExplicitDefaultChangesNothing) {
  const SceneFiles files;
  files.write("t.obj", kTriangle);
  const json schema = schemaJson();
  for (const json& element : schema["elements"])
    for (const json& type : element["types"]) {
      const std::string rest = requiredOf(type, {});
      std::string all = rest;
      for (const json& property : type["properties"])
        if (!property["required"]) all += xmlOf(property);
      EXPECT_EQ(describe(files.load(sceneOf(element, type["type"], rest)).scene),
                describe(files.load(sceneOf(element, type["type"], all)).scene));
    }
}

TEST(SceneSchema, TheReaderTakesEveryOperationListed) {
  const SceneFiles files;
  files.write("t.obj", kTriangle);
  const json schema = schemaJson();
  for (const json& operation : schema["transform"]) {
    std::string text;
    int number = 0;
    for (const json& attribute : operation["attributes"]) {
      const int count = attribute["numbers"];
      std::string
          numbers;  // squares, so that no two triples are parallel; for a matrix the identity
      for (int i = 0; i < count; ++i, ++number)
        numbers +=
            fmt::format("{} ", count == 16 ? (i % 5 == 0 ? 1 : 0) : (number + 1) * (number + 1));
      text += fmt::format(" {}=\"{}\"", attribute["name"].get<std::string>(), numbers);
    }
    const std::string tag = operation["tag"];
    const std::string xml =
        scene(mesh(fmt::format("<transform name=\"toWorld\"><{}{}/></transform>", tag, text)));
    EXPECT_EQ(files.errors(xml), "");
    EXPECT_EQ(files.warnings(xml), "");
  }
}

/// Tags of objects with their types, and names of properties, in an XML document.
std::set<std::string> namesIn(const pugi::xml_node& node) {
  std::set<std::string> names;
  for (const pugi::xml_node child : node.children()) {
    if (child.type() != pugi::node_element) continue;
    const std::string type = child.attribute("type").value(),
                      name = child.attribute("name").value();
    names.insert(type.empty() ? child.name() + (name.empty() ? "" : " " + name)
                              : child.name() + (" " + type));
    names.merge(namesIn(child));
  }
  return names;
}

std::set<std::string> namesListed() {
  std::set<std::string> names;
  const json schema = schemaJson();
  for (const json& element : schema["elements"])
    for (const json& type : element["types"]) {
      names.insert(element["tag"].get<std::string>() + " " + type["type"].get<std::string>());
      for (const json& p : type["properties"])
        names.insert(p["type"].get<std::string>() + " " + p["name"].get<std::string>());
    }
  for (const json& operation : schema["transform"]) names.insert(operation["tag"]);
  return names;
}

TEST(SceneSchema, TheReadmesExampleIsListedAndAccepted) {
  std::ifstream in(std::string(LAVER_SOURCE_DIR) + "/README.md");
  std::stringstream readme;
  readme << in.rdbuf();
  const std::string text = readme.str();
  const std::size_t begin = text.find("<scene>"), end = text.find("</scene>", begin);
  ASSERT_NE(end, std::string::npos);
  const std::string xml = text.substr(begin, end + 8 - begin);
  const SceneFiles files;
  files.write("meshes/bunny.obj", kTriangle);
  EXPECT_EQ(files.errors(xml), "");
  EXPECT_EQ(files.warnings(xml), "");
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(xml.c_str()));
  const auto listed = namesListed();
  for (const std::string& name : namesIn(document.child("scene")))
    EXPECT_EQ(listed.count(name), 1U) << name;
}

TEST(SceneSchema, TheTextHasTheContentOfTheJson) {
  const std::string text = schemaText();
  const json schema = schemaJson();
  for (const json& element : schema["elements"]) {
    EXPECT_NE(text.find("<" + element["tag"].get<std::string>()), std::string::npos);
    for (const json& type : element["types"]) {
      EXPECT_NE(text.find("\n  " + type["type"].get<std::string>() + "\n"), std::string::npos);
      for (const json& p : type["properties"])
        EXPECT_NE(text.find("\n    " + p["name"].get<std::string>() + " "), std::string::npos);
    }
  }
}

TEST(SceneSchema, TheMarkdownHasTablesOfAllTypesAndProperties) {
  const std::string text = schemaMarkdown();
  const json schema = schemaJson();
  for (const json& element : schema["elements"]) {
    if (element["types"].empty()) continue;
    EXPECT_NE(text.find("### `<" + element["tag"].get<std::string>() + ">`\n"), std::string::npos);
    for (const json& type : element["types"]) {
      const std::string row = "\n| `" + type["type"].get<std::string>() + "` | ";
      EXPECT_NE(text.find(row), std::string::npos) << row;
      for (const json& p : type["properties"])
        EXPECT_NE(text.find(row + '`' + p["name"].get<std::string>() + "` "), std::string::npos);
    }
  }
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with('|')) {
      EXPECT_EQ(std::count(line.begin(), line.end(), '|'), 6) << line;
    }
}

}  // namespace
}  // namespace laver::test
