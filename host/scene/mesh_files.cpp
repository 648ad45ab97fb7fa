#include "scene/mesh_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "core/parallel.h"
#include "scene/obj.h"

namespace laver::xml {
namespace {

namespace fs = std::filesystem;

// A file that one or more meshes use; errors are reported at the first of them.
struct MeshFile {
  std::string path;
  std::string name;  // as the scene gives it
  std::size_t offset;
  obj::LoadResult loaded;
};

// Adds the mesh's file to `files` if it is new; returns its index, or -1 without a file.
std::ptrdiff_t indexOf(const TextSource& source, const MeshDraft& mesh,
                       std::map<std::string, std::size_t>& known, std::vector<MeshFile>& files,
                       Diagnostics& diagnostics) {
  if (mesh.filename.empty()) return -1;  // a sphere, or a mesh with an error
  const std::string path = findFile(source.file(), mesh.filename);
  if (path.empty()) {
    diagnostics.error(mesh.offset,
                      fmt::format("mesh file {} not found, expected next to the scene or in the "
                                  "working directory",
                                  inQuotes(mesh.filename)));
    return -1;
  }
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  const auto [entry, added] = known.emplace(error ? path : real.string(), files.size());
  if (added) files.push_back({path, mesh.filename, mesh.offset, {}});
  return static_cast<std::ptrdiff_t>(entry->second);
}

void report(const MeshFile& file, Diagnostics& diagnostics) {
  const obj::LoadResult& loaded = file.loaded;
  if (!loaded.problem.empty()) {
    diagnostics.error(file.offset,
                      fmt::format("mesh file {}: {}", inQuotes(file.name), loaded.problem));
  } else if (loaded.errors.empty() && loaded.data.triangles.empty()) {
    diagnostics.warning(file.offset, fmt::format("mesh file {} has no faces", inQuotes(file.name)));
  }
  for (const std::string& line : loaded.errors) diagnostics.errorLine(file.offset, line);
  for (const std::string& line : loaded.warnings) diagnostics.warningLine(file.offset, line);
}

}  // namespace

std::string findFile(const std::string& sceneFile, const std::string& name) {
  std::error_code error;
  const fs::path beside = fs::path(sceneFile).parent_path() / name;
  if (fs::exists(beside, error)) return beside.string();
  const fs::path working = fs::current_path(error) / name;
  if (!error && fs::exists(working, error)) return working.string();
  return fs::exists(name, error) ? name : std::string();
}

void loadMeshes(const TextSource& source, Draft& draft, Diagnostics& diagnostics) {
  std::map<std::string, std::size_t> known;
  std::vector<MeshFile> files;
  std::vector<std::ptrdiff_t> fileOf;
  for (const MeshDraft& mesh : draft.meshes) {
    fileOf.push_back(indexOf(source, mesh, known, files, diagnostics));
  }
  parallelFor(files.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) files[i].loaded = obj::load(files[i].path);
  });
  for (const MeshFile& file : files) report(file, diagnostics);

  std::vector<Mesh>& meshes = draft.scene.meshes;
  meshes.resize(draft.meshes.size());
  std::vector<char> finite(meshes.size(), 0);
  parallelFor(meshes.size(), 1, 0, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const MeshDraft& from = draft.meshes[i];
      if (fileOf[i] >= 0) {
        const obj::ObjData& data = files[static_cast<std::size_t>(fileOf[i])].loaded.data;
        std::optional<Mesh> mesh = obj::toWorld(data, from.toWorld);
        if (!mesh) continue;
        meshes[i] = std::move(*mesh);
      }
      finite[i] = 1;
      meshes[i].name = from.filename;
      meshes[i].bsdf = from.bsdf;
      meshes[i].sphere = from.sphere;
      meshes[i].light = from.light;
    }
  });
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (finite[i]) continue;
    diagnostics.error(draft.meshes[i].offset,
                      fmt::format("the transform takes a point of {} to infinity",
                                  inQuotes(draft.meshes[i].filename)));
  }
}

}  // namespace laver::xml
