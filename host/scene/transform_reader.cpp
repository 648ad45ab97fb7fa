#include "scene/transform_reader.h"

#include <fmt/format.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/schema.h"
#include "scene/suggest.h"
#include "scene/transform.h"

namespace laver::xml {
namespace {

// One operation of a transform.
class Operation {
 public:
  Operation(pugi::xml_node node, const TextSource& source, Diagnostics& diagnostics)
      : node_(node), source_(source), diagnostics_(diagnostics) {}

  std::optional<glm::dmat4> read() {
    const std::string_view name = node_.name();
    checkNoContent(node_, source_, diagnostics_);
    if (name == "translate" || name == "scale") return readTriple(name == "scale");
    if (name == "rotate") return readRotate();
    if (name == "matrix") return readMatrix();
    return readLookAt();
  }

 private:
  void attributes(std::initializer_list<std::string_view> known) {
    checkAttributes(node_, known, source_, diagnostics_);
  }

  bool numbers(const char* attribute, std::size_t count, double* values) {
    const char* text = requireAttribute(node_, attribute, source_, diagnostics_);
    if (!text) return false;
    const std::string problem = parseNumbers(text, count, values);
    if (!problem.empty()) error(fmt::format("<{}> \"{}\": {}", node_.name(), attribute, problem));
    return problem.empty();
  }

  std::optional<glm::dvec3> triple(const char* attribute) {
    double v[3];
    if (!numbers(attribute, 3, v)) return std::nullopt;
    return glm::dvec3(v[0], v[1], v[2]);
  }

  std::optional<glm::dmat4> readTriple(bool scale) {
    attributes({"value"});
    const auto value = triple("value");
    if (!value) return std::nullopt;
    const glm::dmat4 one(1.0);
    return scale ? glm::scale(one, *value) : glm::translate(one, *value);
  }

  std::optional<glm::dmat4> readRotate() {
    attributes({"axis", "angle"});
    const auto axis = triple("axis");
    double angle = 0.0;
    if (!numbers("angle", 1, &angle) || !axis) return std::nullopt;
    const auto result = rotation(*axis, angle);
    if (!result) error("<rotate> \"axis\" is zero, expected a direction");
    return result;
  }

  std::optional<glm::dmat4> readMatrix() {
    attributes({"value"});
    double m[16];
    if (!numbers("value", 16, m)) return std::nullopt;
    glm::dmat4 result;
    for (int i = 0; i < 16; ++i) result[i % 4][i / 4] = m[i];
    return result;
  }

  std::optional<glm::dmat4> readLookAt() {
    attributes({"target", "origin", "up"});
    const auto target = triple("target");
    const auto origin = triple("origin");
    const auto up = triple("up");
    if (!target || !origin || !up) return std::nullopt;
    const auto result = lookAt(*origin, *target, *up);
    if (!result) {
      error("<lookat> has no direction: expected a target off the origin and an up off the view");
    }
    return result;
  }

  void error(const std::string& message) { diagnostics_.error(offsetOf(node_, source_), message); }

  pugi::xml_node node_;
  const TextSource& source_;
  Diagnostics& diagnostics_;
};

}  // namespace

void checkNoContent(pugi::xml_node node, const TextSource& source, Diagnostics& diagnostics) {
  for (const pugi::xml_node child : node.children()) {
    const std::string what = child.type() == pugi::node_element ? fmt::format("<{}>", child.name())
                                                                : std::string("text");
    diagnostics.error(offsetOf(child, source),
                      fmt::format("{} inside <{}>, expected nothing there", what, node.name()));
  }
}

std::optional<glm::dmat4> readTransform(pugi::xml_node node, const TextSource& source,
                                        Diagnostics& diagnostics) {
  glm::dmat4 result(1.0);
  bool usable = true;
  const auto operations = transformOperations();
  const std::vector<std::string_view> known(operations.begin(), operations.end());
  for (const pugi::xml_node child : node.children()) {
    const std::string_view name = child.name();
    if (child.type() == pugi::node_element && isOperation(name)) {
      const auto matrix = Operation(child, source, diagnostics).read();
      if (matrix) result = *matrix * result;
      usable = usable && matrix;
      continue;
    }
    usable = false;
    diagnostics.error(offsetOf(child, source),
                      child.type() != pugi::node_element
                          ? std::string("text outside of tags in <transform>")
                          : fmt::format("<{}> is no operation of a transform: expected {}", name,
                                        expectedNames(name, known)));
  }
  if (usable && isSingular(result)) {
    diagnostics.error(offsetOf(node, source),
                      fmt::format("the transform {} is singular, expected one that can be undone",
                                  inQuotes(node.attribute("name").value())));
    usable = false;
  }
  return usable ? std::optional(result) : std::nullopt;
}

}  // namespace laver::xml
