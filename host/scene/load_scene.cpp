#include <fmt/format.h>

#include <new>

#include "core/error.h"
#include "scene/mesh_files.h"
#include "scene/node.h"
#include "scene/reader.h"

namespace laver {
namespace {

LoadedScene load(const std::string& file, const SceneOverrides& overrides) {
  xml::FileText read = xml::readFile(file);
  if (!read.problem.empty()) {
    throw Error(ExitCode::Scene, fmt::format("{}: error: {}", file, read.problem));
  }
  if (read.text.starts_with("\xEF\xBB\xBF")) read.text.erase(0, 3);
  const xml::TextSource source(file, std::move(read.text));
  xml::Diagnostics diagnostics(source);
  pugi::xml_document document;
  const pugi::xml_node root = xml::parseDocument(source, document, diagnostics);
  xml::Draft draft{overrides, {}, {}, {}};
  if (root) {
    draft.scene.file = file;
    xml::Reader(source, draft, diagnostics).readScene(root);
    xml::loadMeshes(source, draft, diagnostics);
  }
  diagnostics.throwErrors();
  return {std::move(draft.scene), diagnostics.warnings()};
}

}  // namespace

LoadedScene loadScene(const std::string& file, const SceneOverrides& overrides) {
  try {
    return load(file, overrides);
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::Scene, fmt::format("{}: error: too large for the memory", file));
  }
}

}  // namespace laver
