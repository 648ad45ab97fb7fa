#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
  Draft draft{.overrides = overrides, .scene = {}, .meshes = {}, .meshLights = {}};
  draft.scene.file = source.file();
  if (root) Reader(source, draft, diagnostics).readScene(root);
  if (overrides.filter != nullptr && overrides.filter != draft.scene.filter.row)
    draft.scene.filter = filterOf(*overrides.filter);
  return draft;
}

xml::TextSource xml::sourceOf(const std::string& file) {
  FileText read = readFile(file);
  if (isLfsPointer(read.text)) read.problem = kLfsPointer;
  if (read.problem.empty()) read = utf8Of(std::move(read.text));
  if (!read.problem.empty())
    throw Error(ExitCode::Scene, fmt::format("{}: error: {}", file, read.problem));
  return {file, std::move(read.text)};
}

void xml::loadFiles(const TextSource& source, Draft& draft, Diagnostics& diagnostics) {
  loadTextures(source, draft, diagnostics);
  loadMeshes(source, draft, diagnostics);
  warnOfMissingUvs(draft, diagnostics);
}

namespace {

/// How far a filter has weights that floats can tell from 0, up to half a pixel.
double reachOf(const Filter& filter) {
  double reach = 0.0;
  for (int i = 0; i < 64; ++i) {
    const double x = std::min(0.5, filter.radius) * (i + 1) / 64.0;
    if (std::abs(filter.row->evaluate(filter, x - 1e-9)) > 1e-37) reach = x;
  }
  return reach;
}

/// A sample lies within reach of a pixel's centre with probability (2 reach)^2. Pixels without such
/// a sample stay black: one in a thousand is seen.
void warnOfNarrowFilter(const xml::Draft& draft, xml::Diagnostics& diagnostics) {
  const double share = 4.0 * std::pow(reachOf(draft.scene.filter), 2);
  const double black = std::pow(1.0 - share, draft.scene.sampler.sampleCount);
  if (black <= 1e-3) return;
  diagnostics.warning(
      draft.filterOffset,
      fmt::format("the filter \"{}\" reaches {:.3g} % of a pixel's samples: about {:.3g} % of the "
                  "pixels get none and stay black",
                  draft.scene.filter.row->name, 100.0 * share, 100.0 * black));
}

LoadedScene load(const std::string& file, const SceneOverrides& overrides) {
  const xml::TextSource source = xml::sourceOf(file);
  xml::Diagnostics diagnostics(source);
  xml::Draft draft = xml::readDraft(source, overrides, diagnostics);
  xml::loadFiles(source, draft, diagnostics);
  warnOfNarrowFilter(draft, diagnostics);
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
