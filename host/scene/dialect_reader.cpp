// Which program or course a scene was written for.
#include <fmt/format.h>

#include <string>

#include "scene/reader.h"
#include "scene/suggest.h"

namespace laver::xml {

// Mitsuba's language has the same ancestor; its tags would all be unknown ones.
void Reader::checkDialect(pugi::xml_node root) {
  for (const char* tag : {"sensor", "default", "include"})
    if (root.child(tag)) {
      diagnostics_.error(at(root), fmt::format("this looks like a scene of Mitsuba, as it holds "
                                               "<{}>: expected one of Nori",
                                               tag));
      return;
    }
}

/// Warns once, at the first word that one family alone has.
void Reader::hintAtDialect(pugi::xml_node root) {
  if (draft_.overrides.dialectNamed) return;
  struct Finder : pugi::xml_tree_walker {
    bool for_each(pugi::xml_node& node) override {
      const std::string tag = node.name();
      const std::string both = tag + ' ' + node.attribute("type").value();
      for (const Dialect* dialect : dialects())
        for (const std::string_view word : dialect->vocabulary)
          if (word == tag || word == both) {
            found = node;
            meant = dialect;
            what = std::string(word);
            return false;
          }
      return true;
    }
    pugi::xml_node found;
    const Dialect* meant = nullptr;
    std::string what;
  } finder;
  root.traverse(finder);
  if (finder.meant != nullptr)
    diagnostics_.warning(
        at(finder.found),
        fmt::format("{} belongs to the courses of --dialect {}, where {}", inQuotes(finder.what),
                    finder.meant->name, finder.meant->difference));
}

}  // namespace laver::xml
