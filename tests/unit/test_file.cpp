// Files with the root <test>.
#include "scene/test_file.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

class TestFiles : public testing::Test {
 protected:
  TestFile load(const std::string& text) {
    return loadTestFile(folder_.write("t.xml", text), SceneOverrides());
  }
  /// The errors, without the folder.
  std::string errors(const std::string& text) {
    try {
      load(text);
    } catch (const Error& error) {
      return folder_.withoutPath(error.what());
    }
    return "none";
  }
  TemporaryFolder folder_;
};

const std::string kDiffuse = "<bsdf type=\"diffuse\"/>";

TEST_F(TestFiles, AreKnownByTheirRoot) {
  EXPECT_TRUE(isTestFile(folder_.write("t.xml", "<!-- a --><test type=\"ttest\"/>")));
  EXPECT_FALSE(isTestFile(folder_.write("s.xml", "<scene><test/></scene>")));
  EXPECT_TRUE(isTestFile(folder_.write("b.xml", "<test type=\"ttest\"><bsdf")));
  EXPECT_FALSE(isTestFile(folder_.write("e.xml", "")));
  EXPECT_FALSE(isTestFile(folder_.path("none.xml")));
}

TEST_F(TestFiles, HaveBsdfsWithTheirProperties) {
  const TestFile file = load(
      "<test type=\"ttest\">\n<string name=\"angles\" value=\" 0,\n 45 60\"/>"
      "<string name=\"references\" value=\"0.1, 0.2, 0.3\"/>"
      "<integer name=\"sampleCount\" value=\"1000\"/>"
      "<float name=\"significanceLevel\" value=\"0.05\"/>"
      "<bsdf type=\"microfacet\"><float name=\"alpha\" value=\"0.3\"/></bsdf>" +
      kDiffuse + "</test>");
  EXPECT_EQ(file.kind, TestFile::Kind::Student);
  EXPECT_EQ(file.angles, (std::vector<double>{0.0, 45.0, 60.0}));
  // Those of the angles serve both BSDFs.
  EXPECT_EQ(file.references, (std::vector<double>{0.1, 0.2, 0.3, 0.1, 0.2, 0.3}));
  EXPECT_EQ(file.sampleCount, 1000U);
  EXPECT_EQ(file.significanceLevel, 0.05);
  ASSERT_EQ(file.bsdfs.size(), 2U);
  EXPECT_EQ(file.bsdfs[0].real("alpha"), 0.3);
  EXPECT_STREQ(file.bsdfs[1].row->name, "diffuse");
}

TEST_F(TestFiles, HaveDefaults) {
  const TestFile file = load("<test type=\"chi2test\">" + kDiffuse +
                             "<integer name=\"sampleCount\" value=\"-1\"/></test>");
  EXPECT_EQ(file.kind, TestFile::Kind::ChiSquared);
  EXPECT_EQ(file.sampleCount, 1'000'000U);
  EXPECT_EQ(file.testCount, 5U);
  EXPECT_EQ(file.minExpFrequency, 5U);
  EXPECT_EQ(file.significanceLevel, 0.01);
}

TEST_F(TestFiles, HaveScenes) {
  const TestFile file = load(
      "<test type=\"ttest\"><string name=\"references\" value=\"1 2\"/>"
      "<scene><integrator type=\"path_mis\"/></scene>"
      "<scene><integrator type=\"normals\"/></scene></test>");
  ASSERT_EQ(file.scenes.size(), 2U);
  EXPECT_STREQ(file.scenes[0].integrator.row->name, "path_mis");
  EXPECT_STREQ(file.scenes[1].integrator.row->name, "normals");
}

TEST_F(TestFiles, StateTheirErrorsWithPositions) {
  EXPECT_EQ(errors("<test>" + kDiffuse + "</test>"),
            "t.xml:1:2: error: the type of a test is \"\", expected \"ttest\" or \"chi2test\"");
  EXPECT_EQ(errors("<test type=\"ttest\"/>"),
            "t.xml:1:2: error: nothing to test, expected <bsdf>, <emitter> or <scene>");
  EXPECT_EQ(errors("<test type=\"ttest\">\n" + kDiffuse + "</test>"),
            "t.xml:1:2: error: a ttest of BSDFs needs the property \"angles\"");
  EXPECT_EQ(errors("<test type=\"ttest\">\n<string name=\"angles\" value=\"0 45\"/>"
                   "<string name=\"references\" value=\"1\"/>" +
                   kDiffuse + "</test>"),
            "t.xml:1:2: error: 1 reference values for 2 tests");
  EXPECT_EQ(errors("<test type=\"ttest\">\n<string name=\"angles\" value=\"0 x\"/></test>")
                .find("t.xml:2:2: error: \"x\" is not a number, expected a list of numbers"),
            0U);
  EXPECT_EQ(errors("<test type=\"chi2test\">\n  <bsdf type=\"mirrow\"/></test>")
                .find("t.xml:2:4: error: "),
            0U);
  EXPECT_EQ(
      errors("<test type=\"chi2test\">\n<mesh type=\"obj\"/>" + kDiffuse + "</test>"),
      "t.xml:2:2: error: <mesh> in <test>: expected <bsdf>, <emitter>, <scene> or a property");
  EXPECT_EQ(errors("<test type=\"ttest\">\n<emitter type=\"pointlight\"/>" + kDiffuse + "</test>"),
            "t.xml:1:2: error: a test of several kinds of things, expected one");
  EXPECT_EQ(errors("<test type=\"ttest\">\n<emitter type=\"pointlight\"/></test>"),
            "t.xml:1:2: error: a ttest of emitters needs the property \"distances\"");
  EXPECT_EQ(errors("<test type=\"chi2test\">\n<integer name=\"resolution\" value=\"0\"/>" +
                   kDiffuse + "</test>"),
            "t.xml:2:2: error: resolution must be 1 to 1000, found \"0\"");
  EXPECT_EQ(errors("<test type=\"chi2test\"><scene><integrator type=\"normals\"/></scene></test>"),
            "t.xml:1:2: error: a chi2test tests BSDFs, expected <bsdf>");
}

}  // namespace
}  // namespace laver::test
