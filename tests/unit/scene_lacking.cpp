// Unsupported objects cause only a warning if the picture does not depend on them.
#include "scene/schema.h"
#include "scene/suggest.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

class SceneLacking : public testing::Test {
 protected:
  void SetUp() override { files_.write("t.obj", kTriangle); }
  SceneFiles files_;
};

TEST_F(SceneLacking, UnsupportedObjectsThatTheIntegratorIgnoresAreWarnings) {
  const std::string tail = "; ignored, integrator \"normals\" does not need it";
  EXPECT_EQ(
      files_.warnings(scene("<medium type=\"homogeneous\"><phase type=\"hg\"/></medium>\n"
                            "<test type=\"ttest\"/>\n<emitter type=\"sky\"/>\n" +
                            mesh("<bsdf type=\"velvet\"><foo/></bsdf><emitter type=\"area\"/>\n"
                                 "<subsurface type=\"dipole\"/>") +
                            mesh("<bsdf type=\"diffuse\">\n<texture name=\"albedo\" "
                                 "type=\"perlin\"/></bsdf>"))),
      "f.xml:2:2: warning: laver has no medium of type \"homogeneous\": it has none" + tail +
          "\nf.xml:3:2: warning: laver has no test of type \"ttest\": it has none" + tail +
          "\nf.xml:4:2: warning: laver has no emitter of type \"sky\": expected \"pointlight\", "
          "\"point\", \"spotlight\", \"spot\", \"directional\", \"area\", \"environment\", "
          "\"envmap\", \"constant\" or \"distantdisk\"" +
          tail + "\nf.xml:5:58: warning: laver has no bsdf of type \"velvet\": expected " +
          xml::expectedNames("velvet", xml::knownTypes("bsdf")) +
          "; there is no file velvet.glsl next to the scene either" + tail +
          "\nf.xml:6:2: warning: unknown tag <subsurface>: expected " +
          xml::expectedNames("", xml::knownTags()) + tail +
          "\nf.xml:7:2: warning: laver has no texture of type \"perlin\": expected " +
          xml::expectedNames("perlin", xml::knownTypes("texture")) + tail);
}

TEST_F(SceneLacking, WhittedDoesNotNeedAMediumOrATest) {
  EXPECT_EQ(files_.warnings(scene("<medium type=\"a\"/><test type=\"b\"/>", "direct_whitted")),
            "f.xml:2:2: warning: laver has no medium of type \"a\": it has none; ignored, "
            "integrator \"direct_whitted\" does not need it\n"
            "f.xml:2:20: warning: laver has no test of type \"b\": it has none; ignored, "
            "integrator \"direct_whitted\" does not need it");
}

TEST_F(SceneLacking, MeshWithAnAreaLightKeepsItsGeometry) {
  const auto s = files_.load(scene(mesh("<emitter type=\"area\"/>"), "depth")).scene;
  ASSERT_EQ(s.meshes.size(), 1u);
  EXPECT_EQ(s.meshes[0].triangles.size(), 1u);
}

}  // namespace
}  // namespace laver::test
