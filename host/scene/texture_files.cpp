#include "scene/texture_files.h"

#include <fmt/format.h>

#include <map>

#include "core/error.h"
#include "core/parallel.h"
#include "scene/mesh_files.h"

namespace laver::xml {
namespace {

/// A file that textures or the background use.
struct PictureFile {
  std::string path;
  bool raw;
  std::size_t offset;  // of the first user's tag
  std::vector<std::shared_ptr<const Picture>*> users;
  std::string problem;
};

class PictureFiles {
 public:
  PictureFiles(const TextSource& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  void add(const std::string& name, bool raw, std::size_t offset,
           std::shared_ptr<const Picture>& image) {
    const std::string path = name.empty() ? std::string() : findFile(source_.file(), name);
    if (path.empty()) {
      diagnostics_.error(offset,
                         fmt::format("picture {} not found, expected next to the scene or in the "
                                     "working directory",
                                     inQuotes(name)));
      return;
    }
    const auto [entry, added] = known_.emplace(std::pair(path, raw), files_.size());
    if (added) files_.push_back({path, raw, offset, {}, {}});
    files_[entry->second].users.push_back(&image);
  }

  void read() {
    parallelFor(files_.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) read(files_[i]);
    });
    for (const PictureFile& file : files_)
      if (!file.problem.empty()) diagnostics_.error(file.offset, file.problem);
  }

 private:
  static void read(PictureFile& file) {
    try {
      const auto picture = std::make_shared<const Picture>(readPicture(file.path, file.raw));
      for (auto* user : file.users) *user = picture;
    } catch (const Error& error) {
      file.problem = error.what();
    }
  }

  const TextSource& source_;
  Diagnostics& diagnostics_;
  std::map<std::pair<std::string, bool>, std::size_t> known_;
  std::vector<PictureFile> files_;
};

}  // namespace

void loadTextures(const TextSource& source, Draft& draft, Diagnostics& diagnostics) {
  if (!needsShading(draft)) return;
  PictureFiles files(source, diagnostics);
  for (MeshDraft& mesh : draft.meshes) {
    for (auto& [property, texture] : mesh.bsdf.textures)
      if (texture.row->picture)
        files.add(texture.filename, texture.raw, mesh.textureOffsets.at(property), texture.image);
    if (mesh.light && mesh.light->texture && mesh.light->texture->row->picture) {
      Texture& shown = *mesh.light->texture;
      files.add(shown.filename, shown.raw, mesh.radianceOffset, shown.image);
    }
  }
  if (auto& sky = draft.scene.environment) {
    if (!sky->filename.empty())
      files.add(sky->filename, sky->raw, draft.environmentOffset, sky->image);
    if (!draft.scene.integrator.row->needs.emitters)
      diagnostics.warning(draft.environmentOffset,
                          fmt::format("the background is visible where rays hit nothing but lights "
                                      "no surface: integrator \"{}\" uses point lights only",
                                      draft.scene.integrator.row->name));
  }
  files.read();
  for (MeshDraft& mesh : draft.meshes)
    if (mesh.light && mesh.light->texture)
      mesh.light->radiance =
          mesh.light->scale * mesh.light->texture->row->mean(*mesh.light->texture);
  if (auto& sky = draft.scene.environment;
      sky && sky->encoded && sky->image && sky->filename.ends_with(".exr"))
    sky->radiance /= 255.0;
}

void warnOfMissingUvs(const Draft& draft, Diagnostics& diagnostics) {
  if (!needsShading(draft)) return;
  for (std::size_t i = 0; i < draft.scene.meshes.size(); ++i) {
    const Mesh& mesh = draft.scene.meshes[i];
    const bool onLight = mesh.light && mesh.light->texture;
    if (!mesh.uvs.empty() || mesh.triangles.empty()) continue;
    if (mesh.bsdf.textures.empty() && !onLight) continue;
    const MeshDraft& from = draft.meshes[i];
    diagnostics.warning(mesh.bsdf.textures.empty()
                            ? from.radianceOffset
                            : from.textureOffsets.at(mesh.bsdf.textures.front().property),
                        fmt::format("{} has no texture coordinates: each of its triangles shows "
                                    "the texture from (0, 0) over (1, 0) to (0, 1)",
                                    inQuotes(mesh.name)));
  }
}

}  // namespace laver::xml
