// Integrators from users' files: used at once, and again after an edit.
#include "image/io.h"
#include "pictures/command_line.h"

namespace laver::test {
namespace {

constexpr const char* kGrey =
    "void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {\n"
    "  FOR_RAYS (uint r = 0u; r < R; ++r)\n"
    "    radiance[r] = hits.slot[r] != NO_HIT ? vec3(xml_grey) : vec3(1.0);\n"
    "}\n";

class OwnIntegrator : public CommandLine {
 protected:
  OwnIntegrator() {
    write("t.obj", "v -9 -9 3\nv 9 -9 3\nv 0 9 3\nf 1 2 3\n");
    write("s.xml",
          "<scene><integrator type=\"mine\"><float name=\"grey\" value=\"0.25\"/></integrator>"
          "<camera type=\"perspective\"><rfilter type=\"box\"/>"
          "<integer name=\"width\" value=\"8\"/><integer name=\"height\" value=\"8\"/></camera>"
          "<sampler type=\"independent\"/>"
          "<mesh type=\"obj\"><string name=\"filename\" value=\"t.obj\"/></mesh></scene>");
  }
  Outcome render(const std::string& more = "") {
    return laver("s.xml --device $device --quiet -o a.exr " + more);
  }
  float centre() { return readExr((folder_ / "a.exr").string()).at(4, 4, 0); }
};

TEST_F(OwnIntegrator, NextToTheSceneIsUsedAndRecompiledAfterAnEdit) {
  write("mine.glsl", kGrey);
  Outcome run = render();
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(centre(), 0.25F);
  std::string edited = kGrey;
  edited.replace(edited.find("xml_grey"), 8, "xml_grey * 2.0");
  write("mine.glsl", edited);
  run = render();
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(centre(), 0.5F);
}

TEST_F(OwnIntegrator, OnTheCommandLineReplacesTheScenes) {
  write("mine.glsl", kGrey);
  write("white.glsl",
        "void integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {\n"
        "  FOR_RAYS (uint r = 0u; r < R; ++r) radiance[r] = vec3(3.0);\n}\n");
  const Outcome run = render("--integrator ./white.glsl");
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(centre(), 3.0F);
}

TEST_F(OwnIntegrator, AnErrorNamesItsFileAndLine) {
  write("mine.glsl",
        "\nvoid integrate(Rays rays, Hits hits, inout vec3 radiance[R]) {\n"
        "  radiance[0] = vec3(nonsense);\n}\n");
  const Outcome run = render();
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err.find("mine.glsl:3: error: "), 0U) << run.err;
  EXPECT_NE(run.err.find("nonsense"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.exr"));
}

TEST_F(OwnIntegrator, AnErrorNamesThePropertyThatIsMissing) {
  write("mine.glsl",
        std::string(kGrey).replace(std::string(kGrey).find("xml_grey"), 8, "xml_gray"));
  EXPECT_EQ(render().err,
            "mine.glsl:3: error: 'xml_gray' : undeclared identifier; the element in the scene has "
            "no property \"gray\"\n");
  EXPECT_TRUE(laver("s.xml --device $device -o a.exr").out.ends_with("Rendering .. failed.\n"));
}

TEST_F(OwnIntegrator, IncludesLaversOwnFilesAndNoOthers) {
  write("other.glsl", "");
  write("mine.glsl", std::string("#include \"shared/direction.h\"\n") + kGrey);
  EXPECT_EQ(render().code, 0);
  write("mine.glsl", std::string("#include \"other.glsl\"\n") + kGrey);
  const Outcome run = render();
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err, "mine.glsl:1: error: laver has no file \"other.glsl\" to include\n");
}

TEST_F(OwnIntegrator, TheReferenceRefusesIt) {
  write("mine.glsl", kGrey);
  const Outcome run = render("--reference");
  EXPECT_EQ(run.code, 3);
  EXPECT_NE(run.err.find("mine"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace laver::test
