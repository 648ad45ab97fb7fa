// Collection and positions of errors.
#include "scene/schema.h"
#include "scene/suggest.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

class SceneErrorList : public testing::Test {
 protected:
  SceneFiles files_;
};

TEST_F(SceneErrorList, AllOfAFileInItsOrder) {
  files_.write("bad.obj", "v 0 0 0\nf 1 2 0\n");
  EXPECT_EQ(
      files_.errors("<scene>\n"
                    "<camera type=\"perspective\"><float name=\"fov\" value=\"x\"/></camera>\n"
                    "<mesh type=\"obj\"><string name=\"filename\" value=\"bad.obj\"/></mesh>\n"
                    "<mesh type=\"obj\"><string name=\"filename\" value=\"bad.obj\"/></mesh>\n"
                    "<integrator type=\"nomals\"/>\n"
                    "</scene>"),
      "f.xml:2:29: error: the property \"fov\": \"x\" is not a number, expected a number\n"
      "bad.obj:2: error: vertex index 2 is out of range, the file has 1\n"
      "bad.obj:2: error: vertex index 0, OBJ counts from 1\n"
      "f.xml:5:2: error: laver has no integrator of type \"nomals\": expected \"normals\", "
      "\"direct_whitted\", \"depth\", \"av\", \"ao\", \"geometric_normals\", \"whitted\", "
      "\"direct\", \"direct_ems\", \"direct_mats\", \"direct_mis\", \"path_ems\", \"path_mats\", "
      "\"path_mis\", \"photonmapper\" or \"simple\" (nearest: "
      "\"normals\"); there is no file nomals.glsl next to the scene either");
}

TEST_F(SceneErrorList, AnUnknownIntegratorHidesNoOther) {
  files_.write("t.obj", kTriangle);
  const std::string errors =
      files_.errors(scene(mesh("\n<bsdf type=\"velvet\"/>") + "\n<emitter type=\"sky\"/>\n" +
                              mesh("<bsdf type=\"diffuse\">\n<texture type=\"bitmap\" "
                                   "name=\"albedo\"><string name=\"filename\" value=\"no.png\"/>"
                                   "</texture></bsdf>") +
                              "\n" +
                              mesh("<transform name=\"toWorld\"><matrix value=\"1 0 0 0, 0 1 0 0, "
                                   "0 0 1 0, 1 0 0 -1\"/></transform>"),
                          "vol_path"));
  for (const char* place : {"f.xml:1:9: error: laver has no integrator", "f.xml:3:2: error: ",
                            "f.xml:4:2: error: ", "f.xml:6:2: error: ", "f.xml:7:2: error: "})
    EXPECT_NE(errors.find(place), std::string::npos) << place << "\n" << errors;
}

TEST_F(SceneErrorList, FileThatIsNotThereOrAFolder) {
  const auto messageOf = [&](const std::string& file) -> std::string {
    try {
      loadScene(file);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::Scene);
      return files_.plain(error.what());
    }
    return "none";
  };
  EXPECT_EQ(messageOf(files_.path("nowhere.xml")), "nowhere.xml: error: no such file");
  files_.write("folder/file", "");
  EXPECT_EQ(messageOf(files_.path("folder")), "folder: error: is a folder, expected a file");
}

TEST_F(SceneErrorList, DeepNestingDoesNotOverflowTheStack) {
  std::string open, close;
  for (int i = 0; i < 200000; ++i) {
    open += "<scene>";
    close += "</scene>";
  }
  EXPECT_EQ(files_.errors(open + close), "f.xml:1:450: error: tags are nested more than 64 deep");
}

TEST_F(SceneErrorList, LongNamesAreCut) {
  const std::string errors = files_.errors(scene("", std::string(100000, 'x')));
  EXPECT_LT(errors.size(), 500u);
  EXPECT_NE(errors.find("xxx...\""), std::string::npos);
}

TEST_F(SceneErrorList, ColumnsCountCharactersNotBytes) {
  EXPECT_EQ(
      files_.errors(
          "<scene><!-- \xC3\xA4\xC3\xB6\xC3\xBC --><integrator type=\"normals\"/><x/></scene>"),
      "f.xml:1:49: error: unknown tag <x>: expected " + xml::expectedNames("", xml::knownTags()));
}

TEST_F(SceneErrorList, LinesEndWithLfCrLfOrCr) {
  EXPECT_EQ(files_.errors("<scene>\r\n<integrator type=\"normals\"/>\r\r<camera/>\n</scene>"),
            "f.xml:4:2: error: <camera> needs the attribute \"type\"");
}

}  // namespace
}  // namespace laver::test
