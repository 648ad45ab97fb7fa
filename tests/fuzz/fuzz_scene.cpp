// Arbitrary bytes as a scene file cause errors with positions, or a valid scene.
#include <cmath>
#include <set>
#include <sstream>

#include "core/error.h"
#include "fuzz/fuzz.h"
#include "scene/encoding.h"
#include "scene/mesh_files.h"
#include "scene/reader.h"

namespace laver::fuzz {
namespace {

// Only the seeds of fuzz_obj are available as meshes.
const std::string kFolder = LAVER_SOURCE_DIR "/tests/fuzz/obj/";
const std::set<std::string> kMeshFiles = {"", "triangle.obj", "quad.obj", "faulty.obj"};

bool isFinite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void checkScene(const Scene& scene) {
  require(scene.camera.width >= 1 && scene.camera.height >= 1, "a film has pixels");
  require(scene.sampler.sampleCount >= 1, "a pixel has samples");
  require(scene.filter.radius > 0.0, "a filter has a radius");
  for (const PointLight& light : scene.lights) {
    require(isFinite(light.position) && isFinite(light.radiance), "lights are finite");
  }
  for (const Mesh& mesh : scene.meshes) {
    for (const glm::dvec3& p : mesh.positions) require(isFinite(p), "vertices are finite");
    for (const glm::dvec3& n : mesh.normals) require(isFinite(n), "normals are finite");
    for (const glm::uvec3& t : mesh.triangles) {
      const std::size_t count = mesh.positions.size();
      require(t.x < count && t.y < count && t.z < count, "corners are vertices");
    }
  }
  require(!describe(scene).empty(), "a scene has a description");
}

void checkLines(std::istream&& lines) {
  for (std::string line; std::getline(lines, line);) {
    require(line.starts_with(kFolder), "an error is one line that names its file: " + line);
  }
}

void load(std::string bytes) {
  xml::FileText text = xml::utf8Of(std::move(bytes));
  if (!text.problem.empty()) return;
  const xml::TextSource source(kFolder + "scene.xml", std::move(text.text));
  const SceneOverrides none;
  xml::Diagnostics diagnostics(source);
  xml::Draft draft = xml::readDraft(source, none, diagnostics);
  for (xml::MeshDraft& mesh : draft.meshes) {
    if (!kMeshFiles.contains(mesh.filename)) mesh.filename = "no-such-file.obj";
  }
  xml::loadMeshes(source, draft, diagnostics);
  for (const std::string& line : diagnostics.warnings()) checkLines(std::istringstream(line));
  diagnostics.throwErrors();
  checkScene(draft.scene);
}

}  // namespace
}  // namespace laver::fuzz

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    laver::fuzz::load({reinterpret_cast<const char*>(data), size});
  } catch (const laver::Error& error) {
    laver::fuzz::require(error.code() == laver::ExitCode::Scene, "the exit code is the scene's");
    laver::fuzz::checkLines(std::istringstream(error.what()));
  }
  return 0;
}
