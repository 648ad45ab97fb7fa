#include "scene/node.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/suggest.h"

namespace laver::xml {
namespace {

constexpr int kMaxDepth = 64;

std::string explain(const pugi::xml_parse_result& result) {
  switch (result.status) {
    case pugi::status_unrecognized_tag:
      return "this is not a tag, expected a name after '<'";
    case pugi::status_bad_pi:
      return "a processing instruction or declaration is broken";
    case pugi::status_bad_comment:
      return "a comment does not end, expected \"-->\"";
    case pugi::status_bad_cdata:
      return "a CDATA section does not end, expected \"]]>\"";
    case pugi::status_bad_doctype:
      return "the document type is broken";
    case pugi::status_bad_pcdata:
      return "a text does not end, expected a tag";
    case pugi::status_bad_start_element:
      return "a tag is broken, expected '>' or \"/>\"";
    case pugi::status_bad_attribute:
      return "an attribute is broken, expected name=\"value\"";
    case pugi::status_bad_end_element:
      return "an end tag is broken, expected \"</name>\"";
    case pugi::status_end_element_mismatch:
      return "start and end tags do not match";
    default:
      return result.description();
  }
}

// Iterative, since the depth is not bounded yet.
bool checkDepth(pugi::xml_node root, const TextSource& source, Diagnostics& diagnostics) {
  int depth = 1;
  for (pugi::xml_node node = root; node;) {
    if (depth > kMaxDepth) {
      diagnostics.error(offsetOf(node, source),
                        fmt::format("tags are nested more than {} deep", kMaxDepth));
      return false;
    }
    if (const pugi::xml_node child = node.first_child()) {
      node = child;
      ++depth;
      continue;
    }
    while (node != root && !node.next_sibling()) {
      node = node.parent();
      --depth;
    }
    node = node == root ? pugi::xml_node() : node.next_sibling();
  }
  return true;
}

bool checkText(const TextSource& source, Diagnostics& diagnostics) {
  const std::string& text = source.text();
  if (const std::size_t nul = text.find('\0'); nul != std::string::npos) {
    diagnostics.error(nul, "a NUL byte, expected an XML text");
  } else if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    diagnostics.error(0, "the file is empty, expected <scene>");
  } else if (text.find("WorldBegin") < text.find('<')) {
    diagnostics.error(0, "this looks like a scene of pbrt, expected one of Nori, in XML");
  } else {
    return true;
  }
  return false;
}

}  // namespace

std::size_t offsetOf(pugi::xml_node node, const TextSource& source) {
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
  if (node.type() != pugi::node_pcdata) return offset;
  return std::min(source.text().find_first_not_of(" \t\r\n", offset), source.text().size());
}

void checkAttributes(pugi::xml_node node, const std::vector<std::string_view>& known,
                     const TextSource& source, Diagnostics& diagnostics) {
  std::vector<std::string_view> seen;
  for (const pugi::xml_attribute attribute : node.attributes()) {
    const std::string_view name = attribute.name();
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      diagnostics.warning(
          offsetOf(node, source),
          fmt::format("<{}> takes no attribute {}: ignored{}", node.name(), inQuotes(name),
                      known.empty() ? "" : "; expected " + expectedNames(name, known)));
    } else if (std::find(seen.begin(), seen.end(), name) != seen.end()) {
      diagnostics.warning(
          offsetOf(node, source),
          fmt::format("the attribute {} is given twice; the first one is used", inQuotes(name)));
    }
    seen.push_back(name);
  }
}

const char* requireAttribute(pugi::xml_node node, const char* name, const TextSource& source,
                             Diagnostics& diagnostics) {
  if (const pugi::xml_attribute attribute = node.attribute(name)) return attribute.value();
  diagnostics.error(offsetOf(node, source),
                    fmt::format("<{}> needs the attribute \"{}\"", node.name(), name));
  return nullptr;
}

pugi::xml_node parseDocument(const TextSource& source, pugi::xml_document& document,
                             Diagnostics& diagnostics, std::string_view name) {
  if (!checkText(source, diagnostics)) return {};
  const std::string& text = source.text();
  // Parsed as a fragment, so that text outside of the root is kept and can be reported.
  const auto result = document.load_buffer(
      text.data(), text.size(), pugi::parse_default | pugi::parse_fragment, pugi::encoding_utf8);
  if (!result) {
    diagnostics.error(static_cast<std::size_t>(std::max<std::ptrdiff_t>(result.offset, 0)),
                      "bad XML: " + explain(result));
    return {};
  }
  pugi::xml_node root;
  for (const pugi::xml_node node : document.children()) {
    const std::size_t offset = offsetOf(node, source);
    if (node.type() != pugi::node_element) {
      diagnostics.error(offset, "text outside of tags, expected <scene>");
    } else if (root) {
      diagnostics.error(offset,
                        fmt::format("a second root <{}>, expected one <scene>", node.name()));
    } else {
      root = node;
    }
  }
  if (!root) {
    if (diagnostics.errorCount() == 0) diagnostics.error(0, "no tag, expected <scene>");
    return {};
  }
  if (root.name() != name) {
    diagnostics.error(offsetOf(root, source),
                      fmt::format("the root is <{}>, expected <{}>", root.name(), name));
    return {};
  }
  return checkDepth(root, source, diagnostics) ? root : pugi::xml_node();
}

}  // namespace laver::xml
