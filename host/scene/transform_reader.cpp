#include "scene/transform_reader.h"

#include <fmt/format.h>

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "scene/schema.h"
#include "scene/suggest.h"
#include "scene/transform.h"

namespace laver::xml {
namespace {

// One operation of a transform.
class Operation {
 public:
  Operation(pugi::xml_node node, const TextSource& source, const Dialect& dialect,
            Diagnostics& diagnostics)
      : node_(node), source_(source), dialect_(dialect), diagnostics_(diagnostics) {}

  std::optional<glm::dmat4> read() {
    checkNoContent(node_, source_, diagnostics_);
    const OperationRule& rule = *findOperation(node_.name());
    std::vector<std::string_view> names;
    for (const OperationAttribute& attribute : rule.attributes) names.emplace_back(attribute.name);
    checkAttributes(node_, names, source_, diagnostics_);
    std::array<double, 16> values{};
    std::size_t count = 0;
    bool usable = true;
    for (const OperationAttribute& attribute : rule.attributes) {
      usable = numbers(attribute, &values.at(count)) && usable;
      count += attribute.numbers;
    }
    return usable ? matrixOf(rule.tag, values) : std::nullopt;
  }

 private:
  bool numbers(const OperationAttribute& attribute, double* values) {
    const char* text = requireAttribute(node_, attribute.name, source_, diagnostics_);
    if (!text) return false;
    const std::string problem = parseNumbers(text, attribute.numbers, values);
    if (!problem.empty())
      error(fmt::format("<{}> \"{}\": {}", node_.name(), attribute.name, problem));
    return problem.empty();
  }

  // `v` holds the attributes' numbers in order.
  std::optional<glm::dmat4> matrixOf(std::string_view tag, const std::array<double, 16>& v) {
    const auto triple = [&](std::size_t i) { return glm::dvec3(v[i], v[i + 1], v[i + 2]); };
    const glm::dmat4 one(1.0);
    if (tag == "translate") return glm::translate(one, triple(0));
    if (tag == "scale") return glm::scale(one, triple(0));
    if (tag == "matrix") return glm::transpose(glm::make_mat4(v.data()));
    std::optional<glm::dmat4> result;
    if (tag == "rotate") {
      result = rotation(triple(0), v[3]);
      if (!result) error("<rotate> \"axis\" is zero, expected a direction");
      return result;
    }
    result = (dialect_.scaledLookAt ? scaledLookAt : lookAt)(triple(3), triple(0), triple(6));
    if (!result)
      error("<lookat> has no direction: expected a target off the origin and an up off the view");
    return result;
  }

  void error(const std::string& message) { diagnostics_.error(offsetOf(node_, source_), message); }

  pugi::xml_node node_;
  const TextSource& source_;
  const Dialect& dialect_;
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
                                        const Dialect& dialect, Diagnostics& diagnostics) {
  glm::dmat4 result(1.0);
  bool usable = true;
  for (const pugi::xml_node child : node.children()) {
    const std::string_view name = child.name();
    if (child.type() == pugi::node_element && findOperation(name)) {
      const auto matrix = Operation(child, source, dialect, diagnostics).read();
      if (matrix) result = *matrix * result;
      usable = usable && matrix;
      continue;
    }
    usable = false;
    diagnostics.error(offsetOf(child, source),
                      child.type() != pugi::node_element
                          ? std::string("text outside of tags in <transform>")
                          : fmt::format("<{}> is not an operation of a transform: expected {}",
                                        name, expectedNames(name, knownOperations())));
  }
  if (usable && isSingular(result)) {
    diagnostics.error(offsetOf(node, source),
                      fmt::format("the transform {} is singular, expected an invertible one",
                                  inQuotes(node.attribute("name").value())));
    usable = false;
  }
  return usable ? std::optional(result) : std::nullopt;
}

}  // namespace laver::xml
