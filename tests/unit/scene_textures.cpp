// Textures and backgrounds of scene files: every value reaches its member, and every error has its
// message.
#include <fmt/format.h>

#include "support/picture_files.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

const char* const kUvTriangle =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";

class SceneTextures : public testing::Test {
 protected:
  void SetUp() override {
    files_.write("t.obj", kUvTriangle);
    files_.write("a.png", png(1, 1, 8, PNG_COLOR_TYPE_RGB, {{10, 20, 30}}));
  }
  // A scene for direct_whitted with a mesh whose BSDF contains some tags.
  static std::string whitted(const std::string& insideBsdf, const std::string& after = "") {
    return scene(mesh("<bsdf type=\"diffuse\">\n" + insideBsdf + "</bsdf>") + after,
                 "direct_whitted");
  }
  static std::string picture(const std::string& name, const std::string& inside = "") {
    return "<texture type=\"textmap\" name=\"albedo\"><string name=\"filename\" value=\"" + name +
           "\"/>" + inside + "</texture>";
  }
  SceneFiles files_;
};

/// Without the hint at a dialect.
const SceneOverrides kNamed{.dialectNamed = true};

TEST_F(SceneTextures, ACheckerHasNorisDefaults) {
  const auto loaded = files_.load(whitted("<texture type=\"checker\" name=\"albedo\"/>"));
  EXPECT_TRUE(loaded.warnings.empty());
  const Texture* texture = loaded.scene.meshes.at(0).bsdf.texture("albedo");
  ASSERT_TRUE(texture);
  EXPECT_EQ(texture->row, &textures::checker);
  EXPECT_EQ(texture->colors[0], glm::dvec3(0.9));
  EXPECT_EQ(texture->colors[1], glm::dvec3(0.1));
  EXPECT_EQ(texture->scale, glm::dvec2(1.0));
  EXPECT_EQ(texture->offset, glm::dvec2(0.0));
}

TEST_F(SceneTextures, ANormalMapHasASlotOfItsOwnAndIsLinear) {
  for (const char* name : {"normal", "normalmap"}) {
    const auto loaded = files_.load(
        whitted(fmt::format("<texture type=\"textmap\" name=\"{}\"><string name=\"filename\" "
                            "value=\"a.png\"/></texture>",
                            name)));
    EXPECT_TRUE(loaded.warnings.empty());
    const Texture* map = loaded.scene.meshes.at(0).bsdf.texture(kNormalMap);
    ASSERT_TRUE(map);
    EXPECT_TRUE(map->raw);
    EXPECT_TRUE(map->image);
    EXPECT_EQ(loaded.scene.meshes[0].bsdf.texture("albedo"), nullptr);
  }
}

TEST_F(SceneTextures, ALightsTextureHasItsMeanAndItsScale) {
  const auto loaded = files_.load(
      scene(mesh("<emitter type=\"area\"><float name=\"scale\" value=\"4\"/><texture "
                 "type=\"checkerboard_color\" name=\"radiance\"><color name=\"value1\" value=\"1 2 "
                 "3\"/></texture></emitter>") +
                mesh("<emitter type=\"area\">" +
                     std::string(
                         "<texture type=\"bitmap\" name=\"radiance\"><boolean name=\"raw\" "
                         "value=\"true\"/><string name=\"filename\" value=\"a.png\"/></texture>") +
                     "</emitter>"),
            "path_mis"),
      kNamed);
  EXPECT_TRUE(loaded.warnings.empty());
  const auto& light = loaded.scene.meshes.at(0).light;
  ASSERT_TRUE(light && light->texture);
  EXPECT_EQ(light->radiance, glm::dvec3(4, 6, 8));
  EXPECT_EQ(light->scale, 4.0);
  const auto& shown = loaded.scene.meshes.at(1).light;
  ASSERT_TRUE(shown && shown->texture && shown->texture->image);
  EXPECT_NEAR(shown->radiance.g, 20 / 255.0, 1e-15);
}

TEST_F(SceneTextures, EveryValueReachesItsPlace) {
  const auto s =
      files_
          .load(whitted(
              "<texture type=\"checker\" name=\"albedo\"><color name=\"color1\" value=\"1 2 3\"/>"
              "<color name=\"color2\" value=\"4 5 6\"/><integer name=\"scalex\" value=\"7\"/>"
              "<float name=\"scaley\" value=\"8.5\"/><float name=\"offsetx\" value=\"-9\"/>"
              "<float name=\"offsety\" value=\".5\"/></texture>",
              mesh("<bsdf type=\"diffuse\">" +
                   picture("a.png",
                           "<boolean name=\"raw\" value=\"true\"/>"
                           "<color name=\"color\" value=\".1 .2 .3\"/>"
                           "<float name=\"scalex\" value=\"2\"/>") +
                   "</bsdf>") +
                  "<emitter type=\"envmap\"><string name=\"filename\" value=\"a.png\"/>"
                  "<color name=\"radiance\" value=\"1 2 3\"/><float name=\"scale\" value=\"2\"/>"
                  "<transform name=\"toWorld\"><rotate axis=\"0 1 0\" angle=\"90\"/></transform>"
                  "</emitter>"))
          .scene;
  const Texture& checker = *s.meshes.at(0).bsdf.texture("albedo");
  EXPECT_EQ(checker.colors[0], glm::dvec3(1, 2, 3));
  EXPECT_EQ(checker.colors[1], glm::dvec3(4, 5, 6));
  EXPECT_EQ(checker.scale, glm::dvec2(7, 8.5));
  EXPECT_EQ(checker.offset, glm::dvec2(-9, 0.5));
  const Texture& map = *s.meshes.at(1).bsdf.texture("albedo");
  EXPECT_EQ(map.row, &textures::bitmap);
  EXPECT_TRUE(map.raw);
  EXPECT_EQ(map.colors[0], glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_EQ(map.scale, glm::dvec2(2, 1));
  ASSERT_TRUE(map.image);
  EXPECT_EQ(std::get<Bitmap>(*map.image).pixels.at(0), (Rgb8{10, 20, 30}));
  ASSERT_TRUE(s.environment);
  EXPECT_EQ(s.environment->radiance, glm::dvec3(2, 4, 6));
  EXPECT_FALSE(s.environment->raw);
  EXPECT_NEAR(s.environment->toWorld[2][0], 1.0, 1e-15);
  ASSERT_TRUE(s.environment->image);
}

TEST_F(SceneTextures, EveryNameOfATypeAndAFileIsReadOnce) {
  for (const char* type : {"textmap", "image_texture", "bitmap"}) {
    const std::string bsdf = std::string("<bsdf type=\"diffuse\"><texture type=\"") + type +
                             "\" name=\"albedo\"><string name=\"filename\" value=\"a.png\"/>"
                             "</texture></bsdf>";
    const auto loaded = files_.load(scene(mesh(bsdf) + mesh(bsdf), "direct_whitted"));
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_EQ(loaded.scene.meshes[0].bsdf.texture("albedo")->image,
              loaded.scene.meshes[1].bsdf.texture("albedo")->image);
  }
  for (const char* type : {"environment", "envmap", "constant"}) {
    const auto s = files_
                       .load(scene(std::string("<emitter type=\"") + type +
                                       "\"><color name=\"radiance\" value=\"1 2 3\"/></emitter>",
                                   "direct_whitted"))
                       .scene;
    ASSERT_TRUE(s.environment);
    EXPECT_EQ(s.environment->radiance, glm::dvec3(1, 2, 3));
    EXPECT_FALSE(s.environment->image);
  }
}

TEST_F(SceneTextures, CoursesWriteScaleAndOffsetInTheirOwnWays) {
  const std::string cells =
      "<vector name=\"scale\" value=\"0.5, 0.25\"/>"
      "<point name=\"delta\" value=\"3 5\"/>";
  const std::string file = "<string name=\"filename\" value=\"a.png\"/>";
  struct Written {
    std::string type, inside;
    const char* row;
    glm::dvec2 scale, offset;
    bool raw, red;
  };
  const Written all[] = {
      {"checkerboard_color", cells, "checker", {2, 4}, {-3, -5}, false, false},
      {"checkerboard_float", cells, "checker", {2, 4}, {-3, -5}, false, false},
      {"proceduraltexture", cells, "stripes", {2, 4}, {-3, -5}, false, false},
      {"constant_color", "", "constant", {1, 1}, {0, 0}, false, false},
      {"constant_float", "", "constant", {1, 1}, {0, 0}, false, false},
      {"uvtexture", "", "uv", {1, 1}, {0, 0}, false, false},
      {"image_texture",
       file + "<vector name=\"scale\" value=\"2, 3\"/><vector name=\"shift\" value=\"4 5\"/>"
              "<boolean name=\"linear_rgb\" value=\"false\"/>",
       "bitmap",
       {2, 3},
       {4, 5},
       true,
       false},
      {"image_texture_float",
       file + "<vector name=\"scale\" value=\"2, 4\"/>",
       "bitmap",
       {0.5, 0.25},
       {0, 0},
       true,
       true},
      {"imagetexture",
       "<string name=\"fileName\" value=\"a.png\"/><vector name=\"scale\" value=\"2, 4\"/>",
       "nearest",
       {0.5, 0.25},
       {0, 0},
       true,
       false},
      {"png_texture",
       file + "<float name=\"scaleU\" value=\"2\"/><float name=\"offsetV\" value=\"3\"/>",
       "bitmap",
       {2, 1},
       {0, 3},
       false,
       false}};
  for (const Written& w : all) {
    SCOPED_TRACE(w.type);
    const auto loaded = files_.load(
        whitted("<texture name=\"albedo\" type=\"" + w.type + "\">" + w.inside + "</texture>"),
        kNamed);
    EXPECT_EQ(loaded.warnings.size(), w.type == "image_texture" ? 1U : 0U);
    const Texture* texture = loaded.scene.meshes.at(0).bsdf.texture("albedo");
    ASSERT_NE(texture, nullptr);
    EXPECT_STREQ(texture->row->name, w.row);
    EXPECT_EQ(texture->scale, w.scale);
    EXPECT_EQ(texture->offset, w.offset);
    EXPECT_EQ(texture->raw, w.raw);
    EXPECT_EQ(texture->red, w.red);
    EXPECT_EQ(texture->image != nullptr, texture->row->picture);
  }
}

TEST_F(SceneTextures, AScaleThatCoursesUnderstandInTwoWaysIsAWarning) {
  const std::string file = "<string name=\"filename\" value=\"a.png\"/>";
  EXPECT_EQ(files_.warnings(whitted("\n<texture name=\"albedo\" type=\"image_texture\">" + file +
                                    "\n<vector name=\"scale\" value=\"2, 3\"/></texture>")),
            "f.xml:5:2: warning: scale multiplies u and v; in some courses it divides them");
  EXPECT_EQ(files_.errors(whitted("<texture name=\"albedo\" type=\"checkerboard_color\">"
                                  "\n<vector name=\"scale\" value=\"0, 3\"/></texture>")),
            "f.xml:4:2: error: scale must not be 0");
}

// Zaragoza's course reads files from right to left and does not decode them.
TEST_F(SceneTextures, TextmapIsMirroredInOneDialect) {
  const std::string text = whitted(
      "<texture name=\"albedo\" type=\"textmap\"><string name=\"filename\" value=\"a.png\"/>"
      "</texture>");
  SceneOverrides overrides;
  overrides.dialect = rowCalled(dialects(), "zaragoza");
  const Texture texture = *files_.load(text, overrides).scene.meshes[0].bsdf.texture("albedo");
  EXPECT_EQ(texture.scale, glm::dvec2(-1, 1));
  EXPECT_TRUE(texture.raw);
  EXPECT_EQ(files_.load(text).scene.meshes[0].bsdf.texture("albedo")->scale, glm::dvec2(1));
}

// A course reads both colours of its checker from one property.
TEST_F(SceneTextures, OneColourOfACheckerIsBoth) {
  const auto colors = [&](const std::string& inside) {
    const auto s =
        files_.load(whitted("<texture type=\"checker\" name=\"albedo\">" + inside + "</texture>"))
            .scene;
    return s.meshes.at(0).bsdf.texture("albedo")->colors;
  };
  const std::string both = "<color name=\"color\" value=\"1 2 3\"/>";
  EXPECT_EQ(colors(both)[0], glm::dvec3(1, 2, 3));
  EXPECT_EQ(colors(both)[1], glm::dvec3(1, 2, 3));
  EXPECT_EQ(colors(both + "<color name=\"color2\" value=\"4 5 6\"/>")[1], glm::dvec3(4, 5, 6));
}

TEST_F(SceneTextures, StandForNumbersAndUnderNamesThatEndInMap) {
  const auto loaded = files_.load(
      scene(mesh("<bsdf type=\"disney\"><texture type=\"checkerboard_float\" "
                 "name=\"metallic\"/><texture type=\"image_texture_float\" "
                 "name=\"roughnessmap\"><string name=\"filename\" value=\"a.png\"/></texture>"
                 "</bsdf>"),
            "direct_whitted"),
      kNamed);
  EXPECT_TRUE(loaded.warnings.empty());
  const Bsdf& bsdf = loaded.scene.meshes.at(0).bsdf;
  EXPECT_NE(bsdf.texture("metallic"), nullptr);
  EXPECT_NE(bsdf.texture("roughness"), nullptr);
}

TEST_F(SceneTextures, NoriCompatReadsBytesAsLinear) {
  SceneOverrides overrides;
  overrides.noriCompat = true;
  EXPECT_TRUE(files_.load(whitted(picture("a.png")), overrides)
                  .scene.meshes[0]
                  .bsdf.texture("albedo")
                  ->raw);
}

TEST_F(SceneTextures, MissingAndBrokenFiles) {
  files_.write("b.png", "\x89PNG\r\n\x1a\nrubbish");
  files_.write("c.png", "text");
  EXPECT_EQ(files_.errors(whitted(picture("no.png"))),
            "f.xml:3:2: error: picture \"no.png\" not found, expected next to the scene or in the "
            "working directory");
  EXPECT_EQ(files_.errors(whitted(picture("b.png"))),
            "f.xml:3:2: error: cannot read \"b.png\": it ends too early");
  EXPECT_EQ(files_.errors(whitted(picture("a.png"),
                                  "\n<emitter type=\"envmap\"><string name=\"filename\" "
                                  "value=\"c.png\"/></emitter>")),
            "f.xml:4:2: error: cannot read \"c.png\": it is neither PNG, JPEG nor OpenEXR");
  EXPECT_EQ(files_.errors(whitted("<texture type=\"textmap\" name=\"albedo\"/>")),
            "f.xml:3:2: error: texture \"textmap\" needs the property <string name=\"filename\">");
}

TEST_F(SceneTextures, WrongPlacesAndNames) {
  EXPECT_EQ(files_.errors(whitted("<texture type=\"checker\" name=\"reflectance\"/>")),
            "f.xml:3:2: error: <texture> replaces \"reflectance\" of bsdf \"diffuse\", expected "
            "name=\"albedo\" or \"normal\"");
  EXPECT_EQ(
      files_.errors(scene(mesh("\n<texture type=\"checker\" name=\"albedo\"/>"), "direct_whitted")),
      "f.xml:3:2: error: <texture> is in mesh \"obj\", expected in <bsdf> or "
      "<emitter type=\"area\">");
  EXPECT_EQ(files_.errors(scene(mesh("<emitter type=\"area\">\n<texture type=\"checker\" "
                                     "name=\"scale\"/></emitter>"),
                                "path_mis")),
            "f.xml:3:2: error: <texture> replaces \"scale\" of emitter \"area\", expected "
            "name=\"radiance\"");
  EXPECT_EQ(files_.errors(scene(mesh("\n<emitter type=\"constant\"/>"), "direct_whitted")),
            "f.xml:3:2: error: emitter \"constant\" is in <mesh>, expected in <scene>");
  EXPECT_EQ(files_.errors(scene("<emitter type=\"constant\"/>\n<emitter type=\"environment\"/>",
                                "direct_whitted")),
            "f.xml:3:2: error: emitter \"environment\" is a second background, expected one");
  EXPECT_EQ(files_.errors(scene("<emitter type=\"envmap\"/>", "direct_whitted")),
            "f.xml:2:2: error: emitter \"envmap\" needs <string name=\"filename\"> or <color "
            "name=\"radiance\">");
}

TEST_F(SceneTextures, OddValuesAreWarnings) {
  EXPECT_EQ(files_.warnings(whitted("<color name=\"albedo\" value=\"1 1 1\"/>\n"
                                    "<texture type=\"checker\" name=\"albedo\"/>\n"
                                    "<texture type=\"checker\" name=\"albedo\"/>")),
            "f.xml:4:2: warning: the property \"albedo\" is given twice; the texture is used\n"
            "f.xml:5:2: warning: the property \"albedo\" is given twice; the texture is used\n"
            "f.xml:5:2: warning: the property \"albedo\" is given twice; the last one is used");
  files_.write("t.obj", kTriangle);
  EXPECT_EQ(files_.warnings(whitted("<texture type=\"checker\" name=\"albedo\"/>")),
            "f.xml:3:2: warning: \"t.obj\" has no texture coordinates: each of its triangles shows "
            "the texture from (0, 0) over (1, 0) to (0, 1)");
  EXPECT_EQ(files_.warnings(scene("<emitter type=\"constant\"/>", "direct_whitted")),
            "f.xml:2:2: warning: the background is visible where rays hit nothing but lights no "
            "surface: integrator \"direct_whitted\" uses point lights only");
}

TEST_F(SceneTextures, NormalsAndDepthNeedNoPicture) {
  for (const IntegratorRow* integrator : {&integrators::normals, &integrators::depth}) {
    const auto loaded = files_.load(whitted(picture("no.png"),
                                            "<emitter type=\"envmap\"><string "
                                            "name=\"filename\" value=\"no.exr\"/></emitter>"),
                                    with(*integrator));
    EXPECT_TRUE(loaded.warnings.empty());
    EXPECT_FALSE(loaded.scene.meshes[0].bsdf.texture("albedo")->image);
  }
}

TEST_F(SceneTextures, TheDumpNamesThem) {
  const std::string text =
      describe(files_.load(whitted(picture("a.png"), "<emitter type=\"constant\"/>")).scene);
  EXPECT_NE(text.find("albedo = Texture[name = \"a.png\", color = [1, 1, 1], scale = [1, 1], "
                      "offset = [0, 0]]"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("  envEmitter = EnvironmentEmitter[\n    radiance = [1, 1, 1],"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace laver::test
