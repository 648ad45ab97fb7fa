// Integrators and BSDFs from users' files: reading of scenes, and refusals.
#include "reference/reference.h"
#include "scene/schema.h"
#include "scene/suggest.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

std::string integrator(const std::string& inside, const char* type = "mine") {
  return "<scene><integrator type=\"" + std::string(type) + "\">" + inside +
         "</integrator></scene>";
}

class SceneUser : public testing::Test {
 protected:
  SceneUser() {
    files_.write("mine.glsl", "text of mine");
    files_.write("t.obj", kTriangle);
  }
  const SceneFiles files_;
};

TEST_F(SceneUser, AnIntegratorTakesNumbersOfAnyName) {
  const auto loaded = files_.load(
      integrator("<float name=\"reach\" value=\"0.5\"/><integer name=\"n_2\" value=\"3\"/>"
                 "<color name=\"tint\" value=\"1 2 3\"/><boolean name=\"on\" value=\"true\"/>"));
  EXPECT_TRUE(loaded.warnings.empty());
  const IntegratorUse& use = loaded.scene.integrator;
  ASSERT_NE(use.user, nullptr);
  EXPECT_EQ(use.user->text, "text of mine");
  EXPECT_STREQ(use.row->name, "mine");
  EXPECT_EQ(describe(loaded.scene).substr(0, 66),
            "Scene[\n  integrator = mine[reach=0.5, n_2=3, tint=1 2 3, on=true],");
}

TEST_F(SceneUser, AnIntegratorGetsEverythingAndStatesNoMiss) {
  const IntegratorRow& row = *files_.load(integrator("")).scene.integrator.row;
  EXPECT_TRUE(shades(row));
  EXPECT_TRUE(row.needs.normals && row.needs.numbers);
  EXPECT_EQ(row.miss, Miss::Unknown);
  EXPECT_FALSE(row.litOnly);
}

TEST_F(SceneUser, BuiltInNamesComeFirst) {
  files_.write("depth.glsl", "");
  EXPECT_TRUE(files_.load(integrator("", "depth")).scene.integrator.is(integrators::depth));
}

TEST_F(SceneUser, APropertyMustBeANumberWithANameThatGlslCanTake) {
  const char* const expected =
      "\"mine.glsl\" takes numbers, booleans, points, vectors and colours whose names are letters, "
      "digits and _";
  for (const char* property : {"<float name=\"how far\" value=\"1\"/>",
                               "<string name=\"text\" value=\"1\"/>", "<bsdf type=\"diffuse\"/>"})
    EXPECT_EQ(files_.errors(integrator(std::string("\n") + property)),
              std::string("f.xml:2:2: error: ") + expected);
}

TEST_F(SceneUser, APathIsNotAName) {
  EXPECT_EQ(files_.errors(integrator("", "./mine")),
            "f.xml:1:9: error: laver has no integrator of type \"./mine\": expected " +
                xml::expectedNames("./mine", xml::knownTypes("integrator")));
}

TEST_F(SceneUser, TheCommandLinesIntegratorTakesThePropertiesOfTheSameFile) {
  SceneOverrides overrides;
  overrides.integrator = userIntegrator((files_.path() / "mine.glsl").string());
  ASSERT_TRUE(overrides.integrator);
  const std::string xml = integrator("<float name=\"reach\" value=\"0.5\"/>");
  EXPECT_EQ(files_.load(xml, overrides).scene.integrator.values.size(), 1U);
  EXPECT_TRUE(files_.load(scene(""), overrides).scene.integrator.values.empty());
}

TEST_F(SceneUser, ABsdfTakesAColourOrATextureAndFloats) {
  const Scene s = files_
                      .load(scene(mesh("<bsdf type=\"mine\"><float name=\"alpha\" value=\"0.1\"/>"
                                       "<integer name=\"beta\" value=\"2\"/>"
                                       "<texture type=\"checker\" name=\"kd\"/></bsdf>"),
                                  "direct_whitted"))
                      .scene;
  const Bsdf& bsdf = s.meshes.at(0).bsdf;
  ASSERT_NE(bsdf.user, nullptr);
  EXPECT_EQ(bsdf.user->text, "text of mine");
  EXPECT_EQ(numbersOf(bsdf), (std::vector<double>{0.1, 2.0}));
  ASSERT_NE(bsdf.texture("kd"), nullptr);
  EXPECT_EQ(colorsOf(bsdf), std::vector<glm::dvec3>{glm::dvec3(1.0)});
}

// All meshes share one text, so that a number has the same place in all their records.
TEST_F(SceneUser, MeshesShareABsdfsProperties) {
  const Scene s =
      files_
          .load(scene(mesh("<bsdf type=\"mine\"><float name=\"a\" value=\"1\"/></bsdf>") +
                          mesh("<bsdf type=\"mine\"><float name=\"b\" value=\"2\"/>"
                               "<color name=\"kd\" value=\"3 4 5\"/></bsdf>"),
                      "direct_whitted"))
          .scene;
  EXPECT_EQ(s.meshes.at(0).bsdf.row, s.meshes.at(1).bsdf.row);
  EXPECT_EQ(numbersOf(s.meshes[0].bsdf), (std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(numbersOf(s.meshes[1].bsdf), (std::vector<double>{0.0, 2.0}));
  EXPECT_EQ(s.meshes[0].bsdf.color("kd"), glm::dvec3(1.0));
  EXPECT_EQ(s.meshes[1].bsdf.color("kd"), glm::dvec3(3, 4, 5));
}

TEST_F(SceneUser, ABsdfTakesColoursAndFloatsUpToALimit) {
  const auto of = [](const std::string& inside) {
    return scene(mesh("<bsdf type=\"mine\">" + inside + "</bsdf>"), "direct_whitted");
  };
  const auto real = [](const std::string& name) {
    return "<float name=\"" + name + "\" value=\"1\"/>";
  };
  std::string most = "<color name=\"kd\" value=\"1 1 1\"/><color name=\"ks\" value=\"1 1 1\"/>";
  for (std::size_t i = 2; i < kMostBsdfProperties; ++i) most += real("a" + std::to_string(i));
  EXPECT_EQ(files_.errors(of(most)), "");
  EXPECT_EQ(files_.errors(of(most + "\n" + real("e"))),
            "f.xml:3:2: error: \"mine.glsl\" takes 16 properties at most");
  const std::string message =
      "f.xml:3:2: error: \"mine.glsl\" takes colours and floats whose names are letters, digits "
      "and _";
  EXPECT_EQ(files_.errors(of("\n<vector name=\"v\" value=\"1 1 1\"/>")), message);
  EXPECT_EQ(files_.errors(of("\n" + real("a b"))), message);
}

TEST_F(SceneUser, TheReferenceRefusesUsersCode) {
  const std::string bsdf = mesh("<bsdf type=\"mine\"/>");
  for (const std::string& xml : {integrator(""), scene(bsdf, "direct_whitted")}) {
    const Scene s = files_.load(xml).scene;
    try {
      Reference(s).render();
      ADD_FAILURE() << xml;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::Scene);
      EXPECT_EQ(files_.plain(error.what()),
                "mine.glsl: the reference renders laver's own integrators and BSDFs only");
    }
  }
  // An integrator without materials renders it.
  Scene s = files_.load(scene(bsdf)).scene;
  s.camera.width = s.camera.height = 2;
  EXPECT_NO_THROW(Reference(s).render());
}

}  // namespace
}  // namespace laver::test
