#pragma once
#include <glm/glm.hpp>
#include <optional>

#include "scene/dialects.h"
#include "scene/node.h"

namespace laver::xml {

/// Reads a <transform>. Its operations multiply from the left, so the first one applies first.
/// <lookat> has the meaning that `dialect` gives it.
/// Nothing if an operation or the product is invalid; the errors are then in `diagnostics`.
std::optional<glm::dmat4> readTransform(pugi::xml_node node, const TextSource& source,
                                        const Dialect& dialect, Diagnostics& diagnostics);

/// Reports a tag or a text inside a tag that must be empty.
void checkNoContent(pugi::xml_node node, const TextSource& source, Diagnostics& diagnostics);

}  // namespace laver::xml
