// One scene for each way in which published scenes are written, and the harmless oddities that
// cause warnings.
#include "scene/schema.h"
#include "scene/suggest.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

class SceneWild : public testing::Test {
 protected:
  void SetUp() override { files_.write("t.obj", kTriangle); }
  SceneFiles files_;
};

TEST_F(SceneWild, FirstSceneOfTheHandOut) {
  const auto loaded = files_.load(
      "<?xml version=\"1.0\"?>\n<scene>\n<integrator type=\"normals\">\n"
      "<string name=\"myProperty\" value=\"Hello!\"/>\n</integrator>\n</scene>\n");
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_EQ(
      files_.plain(loaded.warnings[0]),
      "f.xml:4:2: warning: integrator \"normals\" has no property \"myProperty\": ignored; it "
      "takes none");
  const Scene standard;
  EXPECT_EQ(loaded.scene.camera.width, standard.camera.width);
  EXPECT_EQ(loaded.scene.camera.height, standard.camera.height);
  EXPECT_EQ(loaded.scene.sampler.sampleCount, 1u);
  EXPECT_TRUE(loaded.scene.meshes.empty());
}

TEST_F(SceneWild, DefaultsOfTheTableAreThoseOfTheStructs) {
  const Scene s = files_
                      .load(scene("<camera type=\"perspective\"><rfilter type=\"mitchell\"/>"
                                  "</camera><sampler type=\"independent\"/>"
                                  "<emitter type=\"pointlight\"/>" +
                                  mesh("<bsdf type=\"diffuse\"/>")))
                      .scene;
  const Camera camera;
  EXPECT_EQ(s.camera.width, camera.width);
  EXPECT_EQ(s.camera.height, camera.height);
  EXPECT_EQ(s.camera.fov, camera.fov);
  EXPECT_EQ(s.camera.nearClip, camera.nearClip);
  EXPECT_EQ(s.camera.farClip, camera.farClip);
  EXPECT_EQ(s.camera.toWorld, camera.toWorld);
  EXPECT_EQ(s.filter.row, &filters::mitchell);
  EXPECT_EQ(s.filter.radius, 2.0);
  EXPECT_EQ(s.filter.B, Filter().B);
  EXPECT_EQ(s.filter.C, Filter().C);
  EXPECT_EQ(s.sampler.sampleCount, Sampler().sampleCount);
  EXPECT_EQ(s.sampler.seed, Sampler().seed);
  ASSERT_EQ(s.lights.size(), 1u);
  EXPECT_EQ(s.lights[0].position, PointLight().position);
  EXPECT_EQ(s.lights[0].radiance, PointLight().radiance);
  ASSERT_EQ(s.meshes.size(), 1u);
  EXPECT_EQ(s.meshes[0].bsdf.color("albedo"), Bsdf().color("albedo"));
}

TEST_F(SceneWild, EveryValueReachesItsPlace) {
  const auto loaded = files_.load(
      "<!-- before -->\r\n<?xml version='1.0' encoding='utf-8'?>\r\n<!-- the root "
      "-->\r\n<scene>\r\n"
      "<integrator type=\"depth\"/>\r\n<sampler type=\"independent\">"
      "<integer name=\"sampleCount\" value=\" 64 \"/><integer name=\"seed\" value=\"-7\"/>"
      "</sampler>\r\n<camera type=\"perspective\"><float name=\"fov\" value=\".5\"/>"
      "<integer name=\"width\" value=\"+64\"/><integer name=\"height\" value=\"32\"/>"
      "<float name=\"nearClip\" value=\"1e-3\"/><float name=\"farClip\" value=\"1E+3\"/>"
      "<rfilter type=\"gaussian\"><float name=\"radius\" value=\"3\"/>"
      "<float name=\"stddev\" value=\"0.25\"/></rfilter></camera></scene>\r\n");
  EXPECT_TRUE(loaded.warnings.empty());
  const Scene& s = loaded.scene;
  EXPECT_EQ(s.file, files_.path("f.xml"));
  EXPECT_TRUE(s.integrator.is(integrators::depth));
  EXPECT_EQ(s.sampler.sampleCount, 64u);
  EXPECT_EQ(s.sampler.seed, -7);
  EXPECT_EQ(s.camera.fov, 0.5);
  EXPECT_EQ(s.camera.width, 64);
  EXPECT_EQ(s.camera.height, 32);
  EXPECT_EQ(s.camera.nearClip, 1e-3);
  EXPECT_EQ(s.camera.farClip, 1e3);
  EXPECT_EQ(s.filter.row, &filters::gaussian);
  EXPECT_EQ(s.filter.radius, 3.0);
  EXPECT_EQ(s.filter.stddev, 0.25);
}

TEST_F(SceneWild, TriplesWithCommasBlanksOrBoth) {
  for (const char* triple : {"1, 2, 3", "1 2 3", "1,2,3", " 1 ,2  3 ", "1.,2e0,+3", "1\n2\t3"}) {
    const auto loaded =
        files_.load(scene("<emitter type=\"pointlight\"><point name=\"position\" "
                          "value=\"" +
                          std::string(triple) + "\"/></emitter>"));
    EXPECT_EQ(loaded.scene.lights.at(0).position, glm::dvec3(1, 2, 3)) << triple;
    EXPECT_TRUE(loaded.warnings.empty());
  }
}

TEST_F(SceneWild, LookAtInAnyOrderOfAttributes) {
  const auto cameraOf = [&](const std::string& operations) {
    return files_
        .load(scene("<camera type=\"perspective\"><transform name=\"toWorld\">" + operations +
                    "</transform></camera>"))
        .scene.camera.toWorld;
  };
  const glm::dmat4 a = cameraOf("<lookat target=\"0, 0, 5\" origin=\"0, 0, 1\" up=\"0, 7, 0\"/>");
  EXPECT_EQ(a, cameraOf("<lookat up=\"0 1 0\" origin=\"0 0 1\" target=\"0 0 2\"/>"));
  EXPECT_EQ(a, glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1));
  // The mirrored camera of 163 public scenes: the first operation applies first.
  const glm::dmat4 mirrored =
      cameraOf("<scale value=\"-1,1,1\"/><lookat target=\"0 0 5\" origin=\"0 0 1\" up=\"0 1 0\"/>");
  EXPECT_EQ(mirrored, glm::dmat4(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1));
}

TEST_F(SceneWild, OperationsMultiplyFromTheLeft) {
  files_.write("p.obj", "v 1 0 0\nv 1 1 0\nv 1 0 1\nf 1 2 3\n");
  const auto pointOf = [&](const std::string& operations) {
    return files_
        .load(scene("<mesh type=\"obj\"><string name=\"filename\" value=\"p.obj\"/>"
                    "<transform name=\"toWorld\">" +
                    operations + "</transform></mesh>"))
        .scene.meshes.at(0)
        .positions.at(0);
  };
  EXPECT_EQ(pointOf("<translate value=\"1 0 0\"/><scale value=\"2 3 4\"/>"), glm::dvec3(4, 0, 0));
  EXPECT_EQ(pointOf("<scale value=\"2 3 4\"/><translate value=\"1 0 0\"/>"), glm::dvec3(3, 0, 0));
  EXPECT_EQ(pointOf("<matrix value=\"1 0 0 5  0 1 0 6\n0 0 1 7  0 0 0 1\"/>"), glm::dvec3(6, 6, 7));
  EXPECT_EQ(pointOf("<matrix value=\"1 0 0 0, 0 1 0 0, 0 0 1 0, 0 0 0 4\"/>"),
            glm::dvec3(0.25, 0, 0));
  const glm::dvec3 turned = pointOf("<rotate axis=\"0 0 9\" angle=\"90\"/>");
  EXPECT_NEAR(turned.x, 0.0, 1e-15);
  EXPECT_NEAR(turned.y, 1.0, 1e-15);
}

TEST_F(SceneWild, NoSamplerIsOneSample) {
  EXPECT_EQ(files_.load(scene("")).scene.sampler.sampleCount, 1u);
}

TEST_F(SceneWild, BoxFilterHasItsOwnRadius) {
  const auto filterOf = [&](const std::string& type) {
    return files_
        .load(scene("<camera type=\"perspective\"><rfilter type=\"" + type + "\"/></camera>"))
        .scene.filter;
  };
  EXPECT_EQ(filterOf("box").row, &filters::box);
  EXPECT_EQ(filterOf("box").radius, 0.5);
  EXPECT_EQ(filterOf("tent").row, &filters::tent);
  EXPECT_EQ(filterOf("tent").radius, 1.0);
}

TEST_F(SceneWild, ExtraNameOfAnObjectIsFine) {
  EXPECT_EQ(files_.warnings(scene(mesh("<bsdf type=\"diffuse\" name=\"red\"/>"))), "");
}

TEST_F(SceneWild, OtherExtraAttributesAreWarnings) {
  EXPECT_EQ(files_.warnings("<scene version=\"2\">\n<integrator type=\"depth\" id=\"a\"/>\n"
                            "<camera type=\"perspective\"><float name=\"fov\" value=\"3\" "
                            "vaule=\"4\"/></camera></scene>"),
            "f.xml:1:2: warning: <scene> takes no attribute \"version\": ignored\n"
            "f.xml:2:2: warning: <integrator> takes no attribute \"id\": ignored; expected "
            "\"type\" or \"name\"\n"
            "f.xml:3:29: warning: <float> takes no attribute \"vaule\": ignored; expected \"name\" "
            "or \"value\" (nearest: \"value\")");
}

TEST_F(SceneWild, SeveralMeshesWithAndWithoutBsdf) {
  const auto s = files_
                     .load(scene(mesh() +
                                     mesh("<bsdf type=\"diffuse\"><color name=\"albedo\" "
                                          "value=\".1, .2, .3\"/></bsdf>") +
                                     mesh(),
                                 "direct_whitted"))
                     .scene;
  ASSERT_EQ(s.meshes.size(), 3u);
  EXPECT_EQ(s.meshes[0].bsdf.color("albedo"), glm::dvec3(0.5));
  EXPECT_EQ(s.meshes[1].bsdf.color("albedo"), glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(s.meshes[2].bsdf.color("albedo"), glm::dvec3(0.5));
  EXPECT_EQ(s.meshes[2].name, "t.obj");
}

TEST_F(SceneWild, LightsAreInFileOrderAndThoseOfMeshesLast) {
  const auto s =
      files_
          .load(scene(mesh("<emitter type=\"pointlight\"><point name=\"position\" value=\"3 0 0\"/>"
                           "</emitter>") +
                          "<emitter type=\"point\"><point name=\"position\" value=\"1 0 0\"/>"
                          "<color name=\"power\" value=\"1 2 4\"/></emitter>"
                          "<emitter type=\"pointlight\"><point name=\"position\" value=\"2 0 0\"/>"
                          "<color name=\"radiance\" value=\"7 8 9\"/></emitter>",
                      "direct_whitted"))
          .scene;
  ASSERT_EQ(s.lights.size(), 3u);
  EXPECT_EQ(s.lights[0].position.x, 1.0);
  EXPECT_EQ(s.lights[1].position.x, 2.0);
  EXPECT_EQ(s.lights[2].position.x, 3.0);
  EXPECT_DOUBLE_EQ(s.lights[0].radiance.z, 4.0 / (4.0 * 3.14159265358979323846));
  EXPECT_EQ(s.lights[1].radiance, glm::dvec3(7, 8, 9));
}

TEST_F(SceneWild, IntegerForAFloat) {
  const auto loaded = files_.load(
      scene("<camera type=\"perspective\"><integer name=\"fov\" value=\"45\"/></camera>"));
  EXPECT_EQ(loaded.scene.camera.fov, 45.0);
  EXPECT_TRUE(loaded.warnings.empty());
}

TEST_F(SceneWild, UnknownAndDuplicatePropertiesAreWarnings) {
  const std::string xml = scene(
      "<camera type=\"perspective\">\n<float name=\"fow\" value=\"1\"/>\n"
      "<float name=\"fov\" value=\"20\"/>\n<float name=\"fov\" value=\"40\"/></camera>");
  EXPECT_EQ(files_.warnings(xml),
            "f.xml:3:2: warning: camera \"perspective\" has no property \"fow\": ignored; it takes "
            "\"toWorld\", \"width\", \"height\", \"fov\", \"nearClip\", \"farClip\", "
            "\"lensRadius\", \"focalDistance\", \"apertureRadius\", \"focusDistance\", "
            "\"focalLength\" or "
            "\"bokeh\" (nearest: "
            "\"fov\")\n"
            "f.xml:5:2: warning: the property \"fov\" is given twice; the last one is used");
  EXPECT_EQ(files_.load(xml).scene.camera.fov, 40.0);
}

/// A text of ASCII in units of `bytes` bytes, the first or the last of which is the character.
std::string wide(const std::string& text, std::size_t bytes, bool bigEndian) {
  std::string result;
  for (const char c : text) {
    std::string unit(bytes, '\0');
    (bigEndian ? unit.back() : unit.front()) = c;
    result += unit;
  }
  return result;
}

TEST_F(SceneWild, DeclaredAndMarkedEncodings) {
  files_.write("t\xC3\xAAte.obj", kTriangle);
  const auto inEncoding = [](const std::string& name, const std::string& e) {
    return "<?xml version=\"1.0\" encoding=\"" + name + "\"?>\n" +
           scene("<mesh type=\"obj\"><string name=\"filename\" value=\"t" + e +
                 "te.obj\"/></mesh>");
  };
  for (const char* name : {"ISO-8859-1", "latin1", "Windows-1252"})
    EXPECT_EQ(files_.warnings(inEncoding(name, "\xEA")), "") << name;
  for (const char* name : {"UTF-8", "utf-16", "us-ascii", "no-such-thing"})
    EXPECT_EQ(files_.warnings(inEncoding(name, "&#xEA;")), "") << name;
  for (const std::size_t bytes : {2U, 4U})
    for (const bool bigEndian : {false, true}) {
      const std::string text = wide(inEncoding("utf-16", "&#xEA;"), bytes, bigEndian);
      std::string mark(bytes, '\0');
      mark[bigEndian ? bytes - 2 : 0] = bigEndian ? '\xFE' : '\xFF';
      mark[bigEndian ? bytes - 1 : 1] = bigEndian ? '\xFF' : '\xFE';
      EXPECT_EQ(files_.warnings(text), "") << bytes << bigEndian;
      EXPECT_EQ(files_.warnings(mark + text), "") << bytes << bigEndian;
    }
}

TEST_F(SceneWild, PlacesOfErrorsCountCharactersOfAnyEncoding) {
  const std::string xml =
      "<?xml version=\"1.0\" encoding=\"latin1\"?>\n<scene><!-- \xE4\xF6 --><mesh/>";
  EXPECT_NE(files_.errors(xml + "</scene>").find("f.xml:2:20: error: <mesh> needs"),
            std::string::npos);
  EXPECT_NE(files_.errors("\xFF\xFE" + wide("<scene>\n <mesh/></scene>", 2, false))
                .find("f.xml:2:3: error: <mesh> needs"),
            std::string::npos);
}

TEST_F(SceneWild, EncodingsThatDoNotFit) {
  EXPECT_EQ(files_.errors("<?xml version='1.0' encoding='klingon'?><scene/>\xEA"),
            "f.xml: error: its encoding \"klingon\" is not known, expected UTF-8");
  EXPECT_EQ(files_.errors("<?xml version='1.0' encoding='SJIS'?>\xFF"),
            "f.xml: error: its encoding is SJIS, but not at byte 37");
}

TEST_F(SceneWild, ScenesOfOtherRenderersAreNamed) {
  EXPECT_EQ(files_.errors("<scene version=\"2.0.0\"><integrator type=\"depth\"/>\n"
                          "<sensor type=\"perspective\"/>\n<shape type=\"sphere\"/></scene>"),
            "f.xml:1:2: error: this looks like a scene of Mitsuba, as it holds <sensor>: expected "
            "one of Nori\n"
            "f.xml:2:2: error: unknown tag <sensor>: expected " +
                xml::expectedNames("", xml::knownTags()));
  EXPECT_EQ(files_.errors("LookAt 0 0 5  0 0 0  0 1 0\nWorldBegin\nShape \"sphere\"\n"),
            "f.xml:1:1: error: this looks like a scene of pbrt, expected one of Nori, in XML");
}

TEST_F(SceneWild, UnknownTagsThatMayHoldGeometryOrACameraAreErrors) {
  for (const char* inside : {"<object type=\"obj\"/>",
                             "<camera type=\"perspective\">\n"
                             "<lens type=\"thin\"/></camera>"})
    EXPECT_NE(files_.errors(scene(inside)).find("error: unknown tag <"), std::string::npos);
  EXPECT_NE(files_.errors(scene(mesh("<group type=\"a\"><b>" + mesh() + "</b></group>")))
                .find("error: unknown tag <group>"),
            std::string::npos);
  EXPECT_NE(files_.warnings(scene(mesh("<coating type=\"a\"/>"))).find("unknown tag <coating>"),
            std::string::npos);
}

TEST_F(SceneWild, ByteOrderMarkAndEntities) {
  EXPECT_EQ(files_.errors("\xEF\xBB\xBF<scene><x/></scene>").substr(0, 11), "f.xml:1:2: ");
  files_.write("a&b.obj", kTriangle);
  EXPECT_EQ(files_
                .load(scene("<mesh type=\"obj\"><string name=\"filename\" value=\"a&amp;b.obj\"/>"
                            "</mesh>"))
                .scene.meshes.at(0)
                .name,
            "a&b.obj");
}

}  // namespace
}  // namespace laver::test
