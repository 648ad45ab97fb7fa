#include <fmt/format.h>

#include <new>

#include "core/error.h"
#include "core/lfs_pointer.h"
#include "scene/encoding.h"
#include "scene/mesh_files.h"
#include "scene/node.h"
#include "scene/reader.h"
#include "scene/texture_files.h"

namespace laver {

xml::Draft xml::readDraft(const TextSource& source, const SceneOverrides& overrides,
                          Diagnostics& diagnostics) {
  pugi::xml_document document;
  const pugi::xml_node root = parseDocument(source, document, diagnostics);
  Draft draft{overrides, {}, {}, {}, 0};
  draft.scene.file = source.file();
  if (root) Reader(source, draft, diagnostics).readScene(root);
  if (overrides.filter != nullptr && overrides.filter != draft.scene.filter.row)
    draft.scene.filter = filterOf(*overrides.filter);
  return draft;
}

namespace {

LoadedScene load(const std::string& file, const SceneOverrides& overrides) {
  xml::FileText read = xml::readFile(file);
  if (isLfsPointer(read.text)) read.problem = kLfsPointer;
  if (read.problem.empty()) read = xml::utf8Of(std::move(read.text));
  if (!read.problem.empty()) {
    throw Error(ExitCode::Scene, fmt::format("{}: error: {}", file, read.problem));
  }
  const xml::TextSource source(file, std::move(read.text));
  xml::Diagnostics diagnostics(source);
  xml::Draft draft = xml::readDraft(source, overrides, diagnostics);
  xml::loadTextures(source, draft, diagnostics);
  xml::loadMeshes(source, draft, diagnostics);
  xml::warnOfMissingUvs(draft, diagnostics);
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
