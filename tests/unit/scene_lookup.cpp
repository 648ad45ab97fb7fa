// Where mesh files are found, and overrides by the command line.
#include "scene/schema.h"
#include "scene/suggest.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

std::string meshOf(const std::string& file) {
  return scene("<mesh type=\"obj\"><string name=\"filename\" value=\"" + file + "\"/></mesh>");
}

double heightOf(const LoadedScene& loaded) { return loaded.scene.meshes.at(0).positions.at(0).z; }

std::string triangleAt(int z) {
  const std::string h = " " + std::to_string(z) + "\n";
  return "v 0 0" + h + "v 1 0" + h + "v 0 1" + h + "f 1 2 3\n";
}

/// Runs in another working directory.
class WorkingDirectory {
 public:
  explicit WorkingDirectory(const std::string& folder) { std::filesystem::current_path(folder); }
  ~WorkingDirectory() { std::filesystem::current_path(before_); }
  WorkingDirectory(const WorkingDirectory&) = delete;
  WorkingDirectory& operator=(const WorkingDirectory&) = delete;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST(SceneLookup, BesideTheSceneBeforeTheWorkingDirectory) {
  const SceneFiles files;
  files.write("scenes/m.obj", triangleAt(1));
  files.write("work/m.obj", triangleAt(2));
  files.write("work/only.obj", triangleAt(3));
  const std::string a = files.write("scenes/a.xml", meshOf("m.obj"));
  const std::string b = files.write("scenes/b.xml", meshOf("only.obj"));
  const WorkingDirectory inside(files.path("work"));
  EXPECT_EQ(heightOf(loadScene(a)), 1.0);
  EXPECT_EQ(heightOf(loadScene(b)), 3.0);
}

TEST(SceneLookup, SceneOfTheWorkingDirectoryWithoutAPath) {
  const SceneFiles files;
  files.write("m.obj", triangleAt(4));
  files.write("s.xml", meshOf("m.obj"));
  const WorkingDirectory inside(files.path("."));
  EXPECT_EQ(heightOf(loadScene("s.xml")), 4.0);
}

TEST(SceneLookup, ParentFoldersAndAbsolutePaths) {
  const SceneFiles files;
  files.write("meshes/m.obj", triangleAt(5));
  const std::string a = files.write("scenes/a.xml", meshOf("../meshes/m.obj"));
  const std::string b = files.write("scenes/b.xml", meshOf(files.path("meshes/m.obj")));
  EXPECT_EQ(heightOf(loadScene(a)), 5.0);
  EXPECT_EQ(heightOf(loadScene(b)), 5.0);
}

TEST(SceneLookup, ErrorsOfASharedFileAreReportedOnce) {
  const SceneFiles files;
  files.write("m.obj", "f 1\n");
  files.write("sub/x", "");
  EXPECT_EQ(files.errors("<scene><integrator type=\"normals\"/>"
                         "<mesh type=\"obj\"><string name=\"filename\" value=\"m.obj\"/></mesh>"
                         "<mesh type=\"obj\"><string name=\"filename\" value=\"sub/../m.obj\"/>"
                         "</mesh></scene>"),
            "m.obj:1: error: vertex index 1 is out of range, the file has 0");
}

// Cloned without git-lfs; an exporter that failed; a download that was refused.
TEST(SceneLookup, FilesInPlaceOfAMeshAreErrors) {
  const SceneFiles files;
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid sha256:0123\nsize 119802\n";
  files.write("t.obj", pointer);
  EXPECT_EQ(files.errors(scene(mesh())),
            "f.xml:2:2: error: mesh file \"t.obj\": is a pointer of Git LFS, not the file itself: "
            "\"git lfs pull\" fetches it");
  files.write("t.obj", " \r\n");
  EXPECT_EQ(files.errors(scene(mesh())),
            "f.xml:2:2: error: mesh file \"t.obj\": is empty, expected an OBJ file");
  files.write("t.obj", "ply\nformat ascii 1.0\n");
  EXPECT_EQ(
      files.errors(scene(mesh())),
      "t.obj:1: error: \"ply\" is no statement of OBJ, and no line of the file is a vertex or "
      "a face");
  EXPECT_EQ(files.errors(pointer),
            "f.xml: error: is a pointer of Git LFS, not the file itself: \"git lfs pull\" fetches "
            "it");
}

TEST(SceneLookup, SharedFileWithTwoTransforms) {
  const SceneFiles files;
  files.write("t.obj", triangleAt(0));
  const auto s =
      files
          .load(scene(mesh("<transform name=\"toWorld\"><translate value=\"0 0 1\"/></transform>") +
                      mesh("<transform name=\"toWorld\"><translate value=\"0 0 2\"/></transform>")))
          .scene;
  ASSERT_EQ(s.meshes.size(), 2u);
  EXPECT_EQ(s.meshes[0].positions[2], glm::dvec3(0, 1, 1));
  EXPECT_EQ(s.meshes[1].positions[2], glm::dvec3(0, 1, 2));
}

TEST(SceneLookup, MeshWithoutFacesIsAWarning) {
  const SceneFiles files;
  files.write("t.obj", "v 0 0 0\n");
  EXPECT_EQ(files.warnings(scene(mesh())), "f.xml:2:2: warning: mesh file \"t.obj\" has no faces");
  EXPECT_TRUE(files.load(scene(mesh())).scene.meshes.at(0).triangles.empty());
}

TEST(SceneLookup, PointAtInfinity) {
  const SceneFiles files;
  files.write("t.obj", kTriangle);
  EXPECT_EQ(files.errors(scene(mesh("<transform name=\"toWorld\"><matrix value=\"1 0 0 0, 0 1 0 0, "
                                    "0 0 1 0, 1 0 0 -1\"/></transform>"))),
            "f.xml:2:2: error: the transform takes a point of \"t.obj\" to infinity");
}

TEST(SceneOverride, IntegratorMakesAnotherAWarningAndLightsUnneeded) {
  const SceneFiles files;
  files.write("t.obj", kTriangle);
  const std::string xml = scene(mesh("\n<bsdf type=\"velvet\"/>"), "vol_path");
  EXPECT_EQ(files.warnings(xml, with(integrators::normals)),
            "f.xml:1:9: warning: laver has no integrator of type \"vol_path\": expected "
            "\"normals\", \"direct_whitted\", \"depth\", \"av\", \"ao\", \"geometric_normals\", "
            "\"whitted\", \"direct\", \"direct_ems\", \"direct_mats\", \"direct_mis\", "
            "\"path_ems\", \"path_mats\", \"path_mis\", \"photonmapper\" or \"simple\"; there is "
            "no file vol_path.glsl next to "
            "the scene either; "
            "ignored, "
            "integrator \"normals\" does not need it\n"
            "f.xml:3:2: warning: laver has no bsdf of type \"velvet\": expected " +
                xml::expectedNames("velvet", xml::knownTypes("bsdf")) +
                "; there is no file velvet.glsl next to the scene either; ignored, integrator "
                "\"normals\" does not need it");
  EXPECT_EQ(files.errors(xml, with(integrators::directWhitted)),
            "f.xml:3:2: error: laver has no bsdf of type \"velvet\": expected " +
                xml::expectedNames("velvet", xml::knownTypes("bsdf")) +
                "; there is no file velvet.glsl next to the scene either");
  EXPECT_TRUE(files.load(scene("", "depth"), with(integrators::normals))
                  .scene.integrator.is(integrators::normals));
}

TEST(SceneOverride, IntegratorForASceneWithoutOne) {
  const SceneFiles files;
  const auto loaded = files.load("<scene/>", with(integrators::depth));
  EXPECT_TRUE(loaded.scene.integrator.is(integrators::depth));
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST(SceneOverride, SizeSamplesAndSeedReplaceTheScenes) {
  const SceneFiles files;
  SceneOverrides overrides;
  overrides.size = {{30, 20}};
  overrides.sampleCount = 9;
  overrides.seed = -3;
  const std::string bad = scene(
      "<camera type=\"perspective\"><integer name=\"width\" value=\"0\"/></camera>"
      "<sampler type=\"independent\"><integer name=\"sampleCount\" value=\"0\"/></sampler>");
  for (const std::string& xml : {bad, scene("")}) {
    const Scene s = files.load(xml, overrides).scene;
    EXPECT_EQ(s.camera.width, 30);
    EXPECT_EQ(s.camera.height, 20);
    EXPECT_EQ(s.sampler.sampleCount, 9u);
    EXPECT_EQ(s.sampler.seed, -3);
  }
}

TEST(SceneOverride, ASamplerTakesTheCountOfAnyOther) {
  const SceneFiles files;
  SceneOverrides overrides;
  overrides.sampler = &samplers::sobol;
  for (const char* type : {"independent", "halton"}) {
    const Scene s = files
                        .load(scene("<sampler type=\"" + std::string(type) +
                                    "\"><integer name=\"sampleCount\" value=\"8\"/></sampler>"),
                              overrides)
                        .scene;
    EXPECT_EQ(s.sampler.row, &samplers::sobol);
    EXPECT_EQ(s.sampler.sampleCount, 8u);
  }
  EXPECT_EQ(files.load(scene(""), overrides).scene.sampler.row, &samplers::sobol);
}

TEST(SceneSampler, StrataFarFromSquareAreAWarning) {
  const SceneFiles files;
  const auto of = [](const char* count) {
    return scene("<sampler type=\"stratified\"><integer name=\"sampleCount\" value=\"" +
                 std::string(count) + "\"/></sampler>");
  };
  EXPECT_EQ(files.load(of("16")).scene.sampler.row, &samplers::stratified);
  for (const char* count : {"1", "2", "8", "12", "16"}) EXPECT_EQ(files.warnings(of(count)), "");
  EXPECT_EQ(files.warnings(of("10")),
            "f.xml:2:29: warning: 10 samples make strata of 2 x 5 per pixel: 9 or 16 would make "
            "squares");
  EXPECT_EQ(files.errors(of("4294967296")),
            "f.xml:2:29: error: sampleCount must be 1 to 4294967295, found 4294967296");
}

TEST(SceneOverride, AreCheckedThemselves) {
  const SceneFiles files;
  SceneOverrides overrides;
  overrides.size = {{0, 20}};
  overrides.sampleCount = 0;
  EXPECT_EQ(files.errors(scene(""), overrides),
            "f.xml:1:2: error: width must be 1 to 2147483647 pixels, found 0\n"
            "f.xml:1:2: error: sampleCount must be 1 to 4294967295, found 0");
}

}  // namespace
}  // namespace laver::test
