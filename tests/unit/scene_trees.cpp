// Spellings of the course trees, and what the same words mean in each.
#include <cmath>
#include <numbers>

#include "image/io.h"
#include "reference/camera.h"
#include "reference/emitter.h"
#include "scene/schema.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

constexpr double kPi = std::numbers::pi;

SceneOverrides inDialect(const char* name) {
  SceneOverrides overrides;
  overrides.dialect = rowCalled(dialects(), name);
  return overrides;
}

TEST(SceneTrees, ShapeIsAMeshAndLuminaireAnEmitter) {
  const SceneFiles files;
  const Scene s = files
                      .load(scene("<shape type=\"sphere\"><luminaire type=\"area\"><color "
                                  "name=\"radiance\" value=\"1 2 3\"/></luminaire></shape>"))
                      .scene;
  ASSERT_EQ(s.meshes.size(), 1U);
  EXPECT_EQ(s.meshes[0].light->radiance, glm::dvec3(1, 2, 3));
}

TEST(SceneTrees, ASecondEmitterOfAMeshIsAnErrorInAnySpelling) {
  const SceneFiles files;
  EXPECT_NE(files
                .errors(scene("<shape type=\"sphere\"><luminaire type=\"area\"/>"
                              "<emitter type=\"area\"/></shape>"))
                .find("a second <emitter> in <mesh>"),
            std::string::npos);
}

TEST(SceneTrees, APhotonMapIsRenderedByPathsAndSaysSo) {
  const SceneFiles files;
  const std::string text =
      "<scene><integrator type=\"photonmapper\"><integer name=\"photonCount\" value=\"10\"/>"
      "<float name=\"photonRadius\" value=\"0.1\"/></integrator><camera type=\"perspective\"/>"
      "<mesh type=\"sphere\"/></scene>";
  EXPECT_NE(files.warnings(text).find("is rendered by paths"), std::string::npos);
}

TEST(SceneTrees, PathsTakeAMaximumOfBounces) {
  const SceneFiles files;
  const std::string head = "<scene><integrator type=\"path\"><integer name=\"max_depth\" value=\"";
  const std::string tail =
      "\"/></integrator><camera type=\"perspective\"/><mesh type=\"sphere\"/></scene>";
  EXPECT_EQ(files.load(head + "3" + tail).scene.integrator.real("max_depth"), 3.0);
  EXPECT_NE(files.errors(head + "-1" + tail).find("max_depth must be"), std::string::npos);
}

TEST(SceneTrees, OcclusionHasALengthInDiagonalsWhichNori1Presets) {
  const SceneFiles files;
  const std::string text =
      "<scene><integrator type=\"ao\"/><camera type=\"perspective\"/><mesh "
      "type=\"sphere\"/></scene>";
  const auto length = [&](const char* dialect) {
    return files.load(text, inDialect(dialect)).scene.integrator.real("length");
  };
  EXPECT_GE(length("base"), 1.0);
  EXPECT_EQ(length("nori1"), 0.1);
}

/// What arrives at (2 tan(degrees), 0, 0) of a light at (0, 2, 0) that looks down, times the
/// squared distance.
double arriving(const std::string& type, const std::string& inside, double degrees) {
  const SceneFiles files;
  const Scene s =
      files
          .load(scene("<emitter type=\"" + type + "\"><point name=\"position\" value=\"0 2 0\"/>" +
                      inside + "</emitter><mesh type=\"sphere\"/>"))
          .scene;
  const PointLight& light = s.lights.at(0);
  const glm::dvec3 from(2.0 * std::tan(degrees * kPi / 180.0), 0.0, 0.0);
  const double squared = glm::dot(from - light.position, from - light.position);
  return light.row->sample(light, from, 9.0).radiance.y * squared;
}

std::string number(const char* name, double value) {
  return "<float name=\"" + std::string(name) + "\" value=\"" + std::to_string(value) + "\"/>";
}

double cosine(double degrees) { return std::cos(degrees * kPi / 180.0); }

// Expected values are those of the formulas of each tree, up to the rounding of doubles and of six
// digits in the text.
constexpr double kSixDigits = 1e-5;

TEST(SceneTrees, ASpotlightFallsAsASquareOfCosinesFromPower) {
  const std::string inside =
      "<color name=\"power\" value=\"10,20,30\"/><vector name=\"direction\" value=\"0 -3 0\"/>" +
      number("cosFalloffStart", 30) + number("cosTotalWidth", 60);
  const double full = 20.0 / (4.0 * kPi);
  const double share = (cosine(45) - cosine(60)) / (cosine(30) - cosine(60));
  EXPECT_NEAR(arriving("spotlight", inside, 20), full, kSixDigits);
  EXPECT_NEAR(arriving("spotlight", inside, 45), full * share * share, kSixDigits);
  EXPECT_EQ(arriving("spotlight", inside, 61), 0.0);
}

TEST(SceneTrees, ASpotlightFallsLinearlyInTheAngleFromColor) {
  const std::string inside =
      "<color name=\"color\" value=\"10,20,30\"/><vector name=\"direction\" value=\"0 -1 0\"/>" +
      number("cosFalloffStart", 30) + number("cosTotalWidth", 60);
  EXPECT_NEAR(arriving("spotlight", inside, 45), 0.5 * 20.0 / (4.0 * kPi), kSixDigits);
  EXPECT_EQ(arriving("spotlight", inside, 61), 0.0);
}

TEST(SceneTrees, ASpotWithATargetIsAProjectedCone) {
  const std::string inside =
      "<color name=\"power\" value=\"10,20,30\"/><point name=\"target\" value=\"0 1 0\"/>" +
      number("cone", 40) + number("falloff", 40);
  EXPECT_NEAR(arriving("spot", inside, 30), 20.0 * cosine(30), kSixDigits);
  EXPECT_EQ(arriving("spot", inside, 41), 0.0);
}

TEST(SceneTrees, ASpotWithATotalWidthFallsAsAFourthPower) {
  const std::string inside =
      "<color name=\"power\" value=\"10,20,30\"/><vector name=\"direction\" value=\"0 -1 0\"/>" +
      number("totalwidth", 80) + number("falloffstart", 20);
  const double full = 20.0 / (2.0 * kPi * (1.0 - 0.5 * (cosine(20) + cosine(40))));
  const double share = (cosine(30) - cosine(40)) / (cosine(20) - cosine(40));
  EXPECT_NEAR(arriving("spot", inside, 10), full, kSixDigits);
  EXPECT_NEAR(arriving("spot", inside, 30), full * std::pow(share, 4), kSixDigits);
}

TEST(SceneTrees, ASpotWithNeitherLooksAlongItsTransform) {
  const std::string inside =
      "<transform name=\"toWorld\"><rotate axis=\"1 0 0\" angle=\"-90\"/></transform>" +
      number("thetaMax", 30) + number("thetaFall", 10);
  EXPECT_NEAR(arriving("spot", inside, 10), 1000.0, kSixDigits);
  EXPECT_NEAR(arriving("spot", inside, 25), 500.0, 1e-3);
}

TEST(SceneTrees, ASpotNeedsADirection) {
  const SceneFiles files;
  EXPECT_NE(files
                .errors(scene("<emitter type=\"spotlight\"><color name=\"power\" value=\"1 1 1\"/>"
                              "<vector name=\"direction\" value=\"0 0 0\"/></emitter>"))
                .find("direction has no direction"),
            std::string::npos);
}

TEST(SceneTrees, ADirectionalLightArrivesUndiminished) {
  const SceneFiles files;
  const std::string text =
      "<emitter type=\"directional\"><vector name=\"direction\" value=\"0 -2 0\"/>"
      "<color name=\"power\" value=\"1 2 3\"/></emitter>";
  const Scene s = files.load(scene(text + "<mesh type=\"sphere\"/>")).scene;
  const PointLight& light = s.lights.at(0);
  for (const glm::dvec3 from : {glm::dvec3(0.0), glm::dvec3(5.0, -7.0, 1.0)}) {
    const auto sample = light.row->sample(light, from, 9.0);
    EXPECT_EQ(sample.radiance, glm::dvec3(1, 2, 3));
    EXPECT_EQ(sample.position, from + glm::dvec3(0, 9, 0));
  }
}

TEST(SceneTrees, ADirectionalLightWithAnAngleIsADisk) {
  const SceneFiles files;
  const std::string text =
      "<emitter type=\"directional\"><vector name=\"direction\" value=\"1 -2 3\"/>"
      "<color name=\"radiance\" value=\"1 2 3\"/>" +
      number("angle", 1) + "</emitter>";
  const Scene s = files.load(scene(text + "<mesh type=\"sphere\"/>")).scene;
  EXPECT_TRUE(s.lights.empty());
  const Environment& disk = s.environment.value();
  EXPECT_EQ(disk.row->background(disk, {-1, 2, -3}), glm::dvec3(1, 2, 3));
  EXPECT_EQ(disk.row->background(disk, {-1, 2.2, -3}), glm::dvec3(0.0));
}

TEST(SceneTrees, AFloatIsAGreyColorAndPropertiesHaveOtherNames) {
  const SceneFiles files;
  const auto bsdf = [&](const std::string& text) {
    return files.load(scene("<mesh type=\"sphere\">" + text + "</mesh>")).scene.meshes.at(0).bsdf;
  };
  const std::string metal = "<bsdf type=\"conductor\">" + number("eta", 0.25) + "</bsdf>";
  EXPECT_EQ(bsdf(metal).color("eta"), glm::dvec3(0.25));
  const Bsdf disney = bsdf(
      "<bsdf type=\"disneyBSDF\"><color name=\"albedo\" value=\"0.1 0.2 0.3\"/>"
      "<texture type=\"checkerboard_float\" name=\"metallicmap\"/></bsdf>");
  EXPECT_EQ(disney.color("baseColor"), glm::dvec3(0.1, 0.2, 0.3));
  EXPECT_NE(disney.texture("metallic"), nullptr);
  EXPECT_NE(bsdf("<bsdf type=\"disney\"><texture type=\"checker\" name=\"albedo\"/></bsdf>")
                .texture("baseColor"),
            nullptr);
}

TEST(SceneTrees, WordsOfOneFamilyCauseAHintUnlessADialectIsNamed) {
  const SceneFiles files;
  const std::string eth =
      scene("<emitter type=\"point\"><color name=\"power\" value=\"1 1 1\"/></emitter>");
  EXPECT_EQ(
      files.warnings(eth),
      "f.xml:2:2: warning: \"emitter point\" belongs to the courses of --dialect eth, where the "
      "camera is the mirror image");
  SceneOverrides named = inDialect("base");
  named.dialectNamed = true;
  EXPECT_EQ(files.warnings(eth, named), "");
  const std::string old = "<scene><integrator type=\"mipath\"/></scene>";
  EXPECT_NE(files.warnings(old).find("--dialect nori1"), std::string::npos);
  EXPECT_NE(files.warnings("<scene><integrator type=\"path_nee\"/></scene>").find("zaragoza"),
            std::string::npos);
}

TEST(SceneTrees, TheWordsOfFamiliesAreTagsAndTypesThatExist) {
  for (const Dialect* dialect : dialects())
    for (const std::string_view given : dialect->vocabulary) {
      const std::string word(given);
      const std::size_t blank = word.find(' ');
      const std::string tag = word.substr(0, blank);
      const std::string type = blank == std::string::npos ? "area" : word.substr(blank + 1);
      EXPECT_NE(xml::findTag(tag), nullptr) << word;
      EXPECT_NE(xml::findObject(xml::findTag(tag)->tag, type), nullptr) << word;
    }
}

TEST(SceneTrees, TheLookatOfNori1ShrinksByTheAngleBetweenUpAndView) {
  const SceneFiles files;
  const std::string text =
      "<scene><integrator type=\"normals\"/><camera type=\"perspective\"><transform "
      "name=\"toWorld\"><lookat origin=\"0 3 4\" target=\"0 0 0\" up=\"0 2 0\"/></transform>"
      "</camera></scene>";
  const auto left = [&](const char* dialect) {
    return glm::length(files.load(text, inDialect(dialect)).scene.camera.toWorld[0]);
  };
  EXPECT_NEAR(left("eth"), 1.0, 1e-15);
  EXPECT_NEAR(left("nori1"), 0.8, 1e-15);  // the view falls by 3 on 5
}

Camera cameraOf(const std::string& inside, const char* type = "perspective") {
  const SceneFiles files;
  return files
      .load("<scene><integrator type=\"normals\"/><camera type=\"" + std::string(type) + "\">" +
            inside + "</camera></scene>")
      .scene.camera;
}

std::string number(const char* name, const char* value) {
  return "<float name=\"" + std::string(name) + "\" value=\"" + value + "\"/>";
}

TEST(SceneTrees, EachSpellingOfALensIsOne) {
  struct Spelling {
    const char *type, *radius, *distance;
  };
  for (const Spelling& s : {Spelling{"perspective", "lensRadius", "focalDistance"},
                            Spelling{"perspective", "apertureRadius", "focusDistance"},
                            Spelling{"thinlens", "aperture_radius", "focus_distance"},
                            Spelling{"depthoffield", "lensradius", "focaldistance"},
                            Spelling{"dofCamera", "lensRadius", "focalDistance"}}) {
    const Camera camera = cameraOf(number(s.radius, "0.25") + number(s.distance, "3"), s.type);
    EXPECT_EQ(camera.row, &cameras::thinlens) << s.type;
    EXPECT_EQ(camera.lensRadius, 0.25) << s.type;
    EXPECT_EQ(camera.focalDistance, 3.0) << s.type;
  }
  const std::string length = number("lensRadius", "0.25") + number("focalLength", "3");
  EXPECT_EQ(cameraOf(length).row, &cameras::perspective);
  EXPECT_EQ(cameraOf(length + "<boolean name=\"bokeh\" value=\"true\"/>").row, &cameras::thinlens);
  EXPECT_EQ(cameraOf(number("lensRadius", "0") + number("focalDistance", "3")).row,
            &cameras::perspective);
}

TEST(SceneTrees, ALensWithoutADistanceIsAnError) {
  const SceneFiles files;
  EXPECT_NE(files
                .errors("<scene><integrator type=\"normals\"/><camera type=\"perspective\">" +
                        number("lensRadius", "0.25") + "</camera></scene>")
                .find("lensRadius needs focalDistance"),
            std::string::npos);
}

/// All rays of a film position meet in the plane in focus, in the point that the pinhole sees.
TEST(SceneTrees, RaysThroughALensMeetInTheFocalPlane) {
  Camera camera = cameraOf(number("lensRadius", "0.25") + number("focalDistance", "3"));
  camera.toWorld[3] = glm::dvec4(1, 2, 3, 1);
  const reference::View view(camera, glm::dvec3(0));
  const reference::CameraRay centre = view.through({100, 200});
  const glm::dvec3 wanted =
      centre.ray.origin + centre.ray.direction * (3.0 / centre.ray.direction.z);
  for (const glm::dvec2 numbers : {glm::dvec2(1, 0), glm::dvec2(0.5, 0.3), glm::dvec2(0.9, 0.8)}) {
    const reference::CameraRay ray = view.through({100, 200}, reference::Numbers(numbers));
    EXPECT_NEAR(glm::length(ray.ray.origin - centre.ray.origin), 0.25 * std::sqrt(numbers.x),
                1e-15);
    const glm::dvec3 met = ray.ray.origin + ray.ray.direction * (3.0 / ray.ray.direction.z);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(met[i], wanted[i], 1e-14);
    EXPECT_NEAR(ray.tmin * ray.ray.direction.z, camera.nearClip, 1e-18);
  }
}

/// How a tree finds the pixel, as fractions of the image's width and height, of a direction.
using Place = glm::dvec2 (*)(const glm::dvec3& direction);

double turn(double y, double x) {
  const double angle = std::atan2(y, x) / (2.0 * kPi);
  return angle < 0.0 ? angle + 1.0 : angle;
}

/// The environment of a scene shows each direction what the tree's formula finds.
void expectPlaces(const std::string& emitter, const char* dialect, Place place, double factor) {
  const SceneFiles files;
  Image image = rgbImage(8, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = 1.0F + static_cast<float>(i);
  writeExr(files.path("sky.exr"), image);
  const Scene s = files
                      .load("<scene><integrator type=\"path\"/><camera type=\"perspective\"/>" +
                                emitter + "</scene>",
                            inDialect(dialect))
                      .scene;
  ASSERT_TRUE(s.environment);
  for (const glm::dvec3& given :
       {glm::dvec3(0.9, 0.2, 0.35), glm::dvec3(-0.3, 0.8, 0.45), glm::dvec3(0.25, -0.6, 0.7),
        glm::dvec3(0.6, 0.35, -0.7), glm::dvec3(-0.7, -0.3, -0.6)}) {
    const glm::dvec3 d = glm::normalize(given);
    const glm::dvec2 found = place(d);
    // Between the centres of pixels the ramp of the image is linear, but for its border.
    const double x = found.x * 8.0 - 0.5, y = std::clamp(found.y * 4.0 - 0.5, 0.0, 3.0);
    if (x < 0.0 || x > 7.0) continue;
    const double wanted = (1.0 + 3.0 * (8.0 * y + x)) * factor;
    EXPECT_NEAR(s.environment->row->background(*s.environment, d).r, wanted, 1e-6 * wanted)
        << emitter << " in " << dialect;
  }
}

TEST(SceneTrees, SkiesLieAsTheirTreesHaveThem) {
  const auto sky = [](const char* type, const char* name, const std::string& more = "") {
    return "<emitter type=\"" + std::string(type) + "\"><string name=\"" + name +
           "\" value=\"sky.exr\"/>" + more + "</emitter>";
  };
  const Place turned = [](const glm::dvec3& d) {
    return glm::dvec2(0.5 + std::atan2(d.x, -d.z) / (2.0 * kPi), std::acos(d.y) / kPi);
  };
  const Place yUp = [](const glm::dvec3& d) {
    return glm::dvec2(turn(d.x, -d.z), std::acos(d.y) / kPi);
  };
  const Place nadirFirst = [](const glm::dvec3& d) {
    return glm::dvec2(1.0 - turn(d.z, d.x), 1.0 - std::acos(d.y) / kPi);
  };
  const Place zUpReversed = [](const glm::dvec3& d) {
    return glm::dvec2(1.0 - turn(d.y, d.x), std::acos(d.z) / kPi);
  };
  const Place zUp = [](const glm::dvec3& d) {
    return glm::dvec2(turn(d.y, d.x), std::acos(d.z) / kPi);
  };
  expectPlaces(sky("envmap", "filename"), "base", yUp, 1.0);
  expectPlaces(sky("envmap", "filename"), "nori1", turned, 1.0);
  expectPlaces(sky("environment", "filename", "<color name=\"radiance\" value=\"255 255 255\"/>"),
               "zaragoza", nadirFirst, 1.0);
  expectPlaces(sky("envmap", "filename"), "eth", zUpReversed, 1.0);
  expectPlaces(sky("envmap", "filename", number("radiance_scale", "2")), "base", zUpReversed, 2.0);
  expectPlaces(sky("envmap", "mapname"), "base", zUp, 1.0);
  expectPlaces(sky("environment", "path2map"), "base", zUp, 1.0);
  expectPlaces(
      "<mesh type=\"sphere\">" + sky("envmap", "filename", number("strength", "3")) + "</mesh>",
      "base", zUp, 3.0);
}

}  // namespace
}  // namespace laver::test
