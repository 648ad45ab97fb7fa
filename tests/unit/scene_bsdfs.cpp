// BSDFs as scenes write them.
#include <gtest/gtest.h>

#include "support/scene_files.h"

namespace laver::test {
namespace {

class SceneBsdfs : public testing::Test {
 protected:
  SceneBsdfs() { files_.write("t.obj", kTriangle); }
  static std::string with(const std::string& bsdf) { return scene(mesh(bsdf), "direct_whitted"); }
  Bsdf load(const std::string& bsdf) const { return files_.load(with(bsdf)).scene.meshes[0].bsdf; }
  static std::string named(const std::string& type, const std::string& material) {
    return "<bsdf type=\"" + type + "\"><float name=\"alpha\" value=\"0.3\"/>" +
           "<string name=\"material\" value=\"" + material + "\"/></bsdf>";
  }
  /// The error for a value of a property, in line 3.
  std::string errorOf(const std::string& type, const std::string& tag, const std::string& name,
                      const std::string& value) const {
    return files_.errors(with("<bsdf type=\"" + type + "\">\n<" + tag + " name=\"" + name +
                              "\" value=\"" + value + "\"/></bsdf>"));
  }
  const SceneFiles files_;
};

TEST_F(SceneBsdfs, BadValuesAreErrors) {
  EXPECT_EQ(errorOf("dielectric", "float", "intIOR", "0"),
            "f.xml:3:2: error: intIOR must be more than 0, found 0");
  EXPECT_EQ(errorOf("microfacet", "float", "alpha", "0"),
            "f.xml:3:2: error: alpha must be more than 0, found 0");
  EXPECT_EQ(errorOf("microfacet", "color", "kd", "0.5 1.5 0"),
            "f.xml:3:2: error: kd must be 0 to 1, found 0.5 1.5 0");
  EXPECT_EQ(errorOf("disney", "float", "metallic", "2"),
            "f.xml:3:2: error: metallic must be 0 to 1, found 2");
  EXPECT_EQ(errorOf("disney", "float", "sheen", "-1"),
            "f.xml:3:2: error: sheen must be at least 0, found -1");
  EXPECT_EQ(errorOf("disney", "float", "anisotropic", "1.5"),
            "f.xml:3:2: error: anisotropic must be 0 to 1, found 1.5");
  EXPECT_EQ(errorOf("microfacet_conductor", "color", "intIOR", "1 0 1"),
            "f.xml:3:2: error: intIOR must be more than 0, found 1 0 1");
  EXPECT_EQ(errorOf("microfacet_conductor", "color", "intK", "1 -1 1"),
            "f.xml:3:2: error: intK must be at least 0, found 1 -1 1");
  EXPECT_EQ(errorOf("phong", "float", "shininess", "-1"),
            "f.xml:3:2: error: shininess must be at least 0, found -1");
}

TEST_F(SceneBsdfs, AMaterialsNameStandsForItsIndices) {
  const Bsdf bsdf = load(
      "<bsdf type=\"conductor\"><string name=\"material\" value=\"Cu\"/>"
      "<color name=\"k\" value=\"1 2 3\"/></bsdf>");
  EXPECT_EQ(bsdf.color("eta"), glm::dvec3(0.200, 0.924, 1.102));
  EXPECT_EQ(bsdf.color("k"), glm::dvec3(1, 2, 3));
  EXPECT_EQ(load("<bsdf type=\"conductor\"/>").color("eta"), glm::dvec3(0.143, 0.375, 1.442));
}

TEST_F(SceneBsdfs, ARoughConductorOfAMaterialGoesByItsIndices) {
  const Bsdf bsdf = load(named("roughconductor", "Cr"));
  EXPECT_STREQ(bsdf.row->name, "microfacet_conductor");
  EXPECT_EQ(bsdf.color("intIOR"), glm::dvec3(4.370, 2.917, 1.655));
  EXPECT_EQ(bsdf.real("alpha"), 0.3);
  EXPECT_STREQ(load("<bsdf type=\"roughconductor\"/>").row->name, "roughconductor");
}

TEST_F(SceneBsdfs, AnUnknownMaterialIsAnError) {
  EXPECT_EQ(
      files_.errors(with("\n" + named("microfacet_conductor", "Xx"))),
      "f.xml:3:69: error: bsdf \"microfacet_conductor\" has no material \"Xx\": expected \"Au\", "
      "\"Cu\" or \"Cr\"");
}

TEST_F(SceneBsdfs, OtherNamesOfABsdf) {
  EXPECT_STREQ(load("<bsdf type=\"roughdielectric\"/>").row->name, "microfacet_dielectric");
}

}  // namespace
}  // namespace laver::test
