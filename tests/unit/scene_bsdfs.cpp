// BSDFs as scenes write them.
#include <gtest/gtest.h>

#include "support/scene_files.h"

namespace laver::test {
namespace {

class SceneBsdfs : public testing::Test {
 protected:
  SceneBsdfs() { files_.write("t.obj", kTriangle); }
  static std::string with(const std::string& bsdf) { return scene(mesh(bsdf), "direct_whitted"); }
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
  EXPECT_EQ(errorOf("disney", "float", "anisotropic", "0.5"),
            "f.xml:3:2: error: anisotropic must be 0, found 0.5");
}

}  // namespace
}  // namespace laver::test
