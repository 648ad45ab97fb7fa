// Numbers, names and the dump.
#include <clocale>
#include <random>

#include "scene/numbers.h"
#include "scene/schema.h"
#include "scene/suggest.h"
#include "scene/text_source.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

TEST(SceneNumbers, Reals) {
  EXPECT_EQ(parseReal("-1.5e-3").value, -1.5e-3);
  EXPECT_EQ(parseReal(".5").value, 0.5);
  EXPECT_EQ(parseReal("5.").value, 5.0);
  EXPECT_EQ(parseReal("+2").value, 2.0);
  EXPECT_EQ(parseReal("0.1").value, 0.1);
  EXPECT_EQ(parseReal("4.9e-324").value, 4.9e-324);
  for (const char* tiny : {"1e-400", "-1e-400", "0.00001e-330", "1000e-400"}) {
    EXPECT_TRUE(parseReal(tiny)) << tiny;
    EXPECT_EQ(parseReal(tiny).value, 0.0) << tiny;
  }
  for (const char* bad :
       {"", " 1", "1 ", "--1", "+-1", "++1", "0x10", "1f", "1e", "e1", ".", "+", "1,5"}) {
    EXPECT_STREQ(parseReal(bad).problem, "is not a number") << bad;
  }
  for (const char* large : {"1e309", "-1e400", "1000000e305", "0.001e999"}) {
    EXPECT_STREQ(parseReal(large).problem, "is too large for a number") << large;
  }
  for (const char* infinite : {"inf", "-infinity", "nan", "NaN"}) {
    EXPECT_STREQ(parseReal(infinite).problem, "is not a finite number") << infinite;
  }
}

TEST(SceneNumbers, Integers) {
  EXPECT_EQ(parseInteger("-12").value, -12);
  EXPECT_EQ(parseInteger("+9223372036854775807").value, INT64_MAX);
  EXPECT_STREQ(parseInteger("9223372036854775808").problem, "is too large for an integer");
  EXPECT_STREQ(parseInteger("1e3").problem, "is not an integer");
}

TEST(SceneNumbers, DoNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  EXPECT_EQ(parseReal("1.5").value, 1.5);
  std::setlocale(LC_ALL, before.c_str());
}

TEST(SceneNames, EditDistance) {
  using xml::editDistance;
  EXPECT_EQ(editDistance("fov", "fov"), 0u);
  EXPECT_EQ(editDistance("fow", "fov"), 1u);
  EXPECT_EQ(editDistance("ofv", "fov"), 1u);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3u);
  EXPECT_EQ(editDistance("", "abc"), 3u);
  EXPECT_EQ(editDistance(std::string(1000, 'a'), ""), 64u);
}

TEST(SceneNames, Nearest) {
  EXPECT_EQ(xml::nearest("hight", {"width", "height"}), "height");
  EXPECT_EQ(xml::nearest("a", {}), "");
  EXPECT_EQ(xml::nearest("FLOAT", {"mesh", "float"}), "float");
  EXPECT_EQ(xml::nearest("path_mis", {"normals", "depth"}), "");
  EXPECT_EQ(xml::nearest("x", {"ao", "y"}), "") << "all of it would be a slip";
  EXPECT_EQ(xml::expectedNames("x", {"one"}), "\"one\"");
}

TEST(SceneNames, QuotesAreSafeToPrint) { EXPECT_EQ(xml::inQuotes("a\nb\x1b"), "\"a?b?\""); }

// Invariants of the tables: each default parses as its type, and each object builds from defaults.
TEST(SceneSchema, DefaultsAreWellFormed) {
  for (const xml::ObjectRule& rule : xml::objectRules()) {
    EXPECT_NE(xml::findTag(rule.tag), nullptr) << rule.tag;
    EXPECT_EQ(xml::findObject(rule.tag, rule.type), &rule);
    for (const PropertyRow& property : rule.properties) {
      if (property.required || property.type == PropertyType::Transform) continue;
      Value value;
      EXPECT_EQ(xml::parseValue(property.type, textOf(property.start), value), "") << property.name;
      EXPECT_EQ(value, property.start) << property.name;
    }
  }
}

TEST(SceneSchema, IntegratorNamesAreThoseOfTheTable) {
  for (const std::string_view name : xml::knownTypes("integrator")) {
    const IntegratorRow* row = rowCalled(integratorRows(), name);
    ASSERT_NE(row, nullptr) << name;
    EXPECT_EQ(row->name, name);
  }
  EXPECT_EQ(rowCalled(integratorRows(), "vol_path"), nullptr);
}

TEST(SceneDescribe, EmptySceneIsTheHandOuts) {
  const SceneFiles files;
  EXPECT_EQ(describe(files.load(scene("")).scene),
            "Scene[\n"
            "  integrator = NormalIntegrator[],\n"
            "  sampler = Independent[sampleCount=1]\n"
            "  camera = PerspectiveCamera[\n"
            "    cameraToWorld = [1, 0, 0, 0;\n"
            "                     0, 1, 0, 0;\n"
            "                     0, 0, 1, 0;\n"
            "                     0, 0, 0, 1],\n"
            "    outputSize = [1280, 720],\n"
            "    fov = 30.000000,\n"
            "    clip = [0.000100, 10000.000000],\n"
            "    rfilter = GaussianFilter[radius=2.000000, stddev=0.500000]\n"
            "  ],\n"
            "  medium = null,\n"
            "  envEmitter = null,\n"
            "  meshes = {\n"
            "  }\n"
            "]");
}

TEST(SceneDescribe, Samplers) {
  const SceneFiles files;
  for (const auto& [type, text] :
       {std::pair("stratified", "  sampler = Stratified[sampleCount=1]\n"),
        std::pair("sobol", "  sampler = Sobol[sampleCount=1]\n")})
    EXPECT_NE(describe(files.load(scene("<sampler type=\"" + std::string(type) + "\"/>")).scene)
                  .find(text),
              std::string::npos);
}

TEST(SceneDescribe, MeshesLightsFilterAndSeed) {
  const SceneFiles files;
  files.write("t.obj", kTriangle);
  const std::string text = describe(
      files
          .load(scene("<sampler type=\"independent\"><integer name=\"seed\" value=\"5\"/></sampler>"
                      "<camera type=\"perspective\"><rfilter type=\"box\"/></camera>"
                      "<emitter type=\"pointlight\"/>" +
                          mesh() + mesh(),
                      "direct_whitted"))
          .scene);
  EXPECT_NE(text.find("  integrator = DirectWhittedIntegrator[],\n"
                      "  sampler = Independent[sampleCount=1, seed=5]\n"),
            std::string::npos);
  EXPECT_NE(text.find("    rfilter = BoxFilter[]\n"), std::string::npos);
  const std::string meshText =
      "    Mesh[\n"
      "      name = \"t.obj\",\n"
      "      vertexCount = 3,\n"
      "      triangleCount = 1,\n"
      "      bsdf = Diffuse[\n"
      "        albedo = [0.5, 0.5, 0.5]\n"
      "      ],\n"
      "      emitter = null\n"
      "    ]";
  EXPECT_NE(text.find("  envEmitter = null,\n"
                      "  emitters = {\n"
                      "    PointEmitter[\n"
                      "      position = [0, 100, 0],\n"
                      "      radiance = [1, 1, 1]\n"
                      "    ]\n"
                      "  },\n"
                      "  meshes = {\n" +
                      meshText + ",\n" + meshText + "\n  }\n]"),
            std::string::npos);
}

// A damaged file causes either a scene or an Error of the right kind, nothing else.
TEST(SceneDamage, NeverEscapesTheErrorType) {
  const SceneFiles files;
  files.write("t.obj", kTriangle);
  const std::string good =
      "<?xml version=\"1.0\"?><!-- c -->" +
      scene(
          "<camera type=\"perspective\"><transform name=\"toWorld\"><scale value=\"-1,1,1\"/>"
          "<lookat target=\"0 0 1\" origin=\"0 0 0\" up=\"0 1 0\"/></transform>"
          "<integer name=\"width\" value=\"4\"/><rfilter type=\"box\"/></camera>" +
              mesh("<bsdf type=\"diffuse\"><color name=\"albedo\" value=\"1 1 1\"/></bsdf>"),
          "direct_whitted");
  std::mt19937 random(1);
  const std::string letters = "<>/\"'=&; \n\t\r01eE+-.xaz!?[]\xff";
  int loaded = 0, refused = 0;
  for (int round = 0; round < 300; ++round) {
    std::string xml = good;
    for (auto edits = 1 + random() % 2; edits > 0; --edits) {
      const std::size_t at = random() % xml.size();
      switch (random() % 4) {
        case 0:
          xml[at] = letters[random() % letters.size()];
          break;
        case 1:
          xml.erase(at, 1 + random() % 9);
          break;
        case 2:
          xml.insert(at, xml.substr(random() % xml.size(), random() % 40));
          break;
        default:
          xml.resize(at + 1);
      }
    }
    if (files.errors(xml).empty()) {
      ++loaded;
    } else {
      ++refused;
    }
  }
  EXPECT_GT(loaded, 5);
  EXPECT_GT(refused, 100);
}

TEST(SceneDamage, OfMeshesNeverEscapesTheErrorType) {
  const SceneFiles files;
  const std::string good =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvt 0 0\nvn 0 0 1\nf 1/1/1 2//1 -2\nf 1 2 3 4\n";
  std::mt19937 random(2);
  const std::string letters = "vfn/-0123456789.e# \\\n\r\t";
  int loaded = 0;
  for (int round = 0; round < 300; ++round) {
    std::string text = good;
    for (auto edits = 1 + random() % 2; edits > 0; --edits) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) {
        text[at] = letters[random() % letters.size()];
      } else {
        text.erase(at, 1 + random() % 5);
      }
    }
    files.write("t.obj", text);
    if (files.errors(scene(mesh())).empty()) ++loaded;
  }
  EXPECT_GT(loaded, 10);
}

}  // namespace
}  // namespace laver::test
