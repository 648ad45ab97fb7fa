// Test files run on the device: true hypotheses are accepted, false ones rejected.
#include "pictures/command_line.h"

namespace laver::test {
namespace {

/// Cosine-distributed directions about +z, which is the normal in tests of BSDFs.
std::string ownBsdf(const std::string& pdf, const std::string& weight) {
  return "vec3 mineEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {\n"
         "  return light * m.albedo * 0.31830989;\n}\n"
         "float minePdf(Material m, vec3 normal, vec3 wi, vec3 wo) {\n"
         "  return " +
         pdf +
         ";\n}\n"
         "vec3 mineSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {\n"
         "  const float r = sqrt(numbers.x), phi = 6.2831853 * numbers.y;\n"
         "  wo = vec3(r * cos(phi), r * sin(phi), sqrt(1.0 - numbers.x));\n"
         "  return " +
         weight + ";\n}\n";
}

constexpr const char* kCosine = "wo.z > 0.0 ? wo.z * 0.31830989 : 0.0";
constexpr const char* kOwn =
    "<bsdf type=\"mine\"><color name=\"albedo\" value=\"0.5 0.5 0.5\"/></bsdf></test>";

class TestFilesOfDevice : public CommandLine {
 protected:
  Outcome run(const std::string& text, const std::string& arguments = "--device $device") {
    write("t.xml", text);
    return laver("t.xml " + arguments);
  }
  Outcome student() {
    return run(std::string("<test type=\"ttest\"><string name=\"angles\" value=\"0 60\"/>"
                           "<string name=\"references\" value=\"0.5 0.5\"/>") +
               kOwn);
  }
  Outcome chiSquared() { return run(std::string("<test type=\"chi2test\">") + kOwn); }
};

bool says(const Outcome& outcome, const char* text) {
  return outcome.out.find(text) != std::string::npos;
}

TEST_F(TestFilesOfDevice, AcceptARightBsdfOfAUser) {
  write("mine.glsl", ownBsdf(kCosine, "m.albedo"));
  const Outcome means = student(), directions = chiSquared();
  EXPECT_EQ(means.code, 0) << means.out << means.err;
  EXPECT_TRUE(says(means, "Passed 2/2 tests.")) << means.out;
  EXPECT_EQ(directions.code, 0) << directions.out << directions.err;
  EXPECT_TRUE(says(directions, "Passed 5/5 tests.")) << directions.out;
  EXPECT_EQ(files(), (std::set<std::string>{"mine.glsl", "t.xml"}));
}

TEST_F(TestFilesOfDevice, RejectAWrongDensity) {
  write("mine.glsl", ownBsdf("wo.z > 0.0 ? 0.15915494 : 0.0", "m.albedo"));
  const Outcome outcome = chiSquared();
  EXPECT_EQ(outcome.code, 5);
  EXPECT_TRUE(says(outcome, "***** Rejected ***** the null hypothesis")) << outcome.out;
  EXPECT_TRUE(says(outcome, "Passed 0/5 tests.")) << outcome.out;
}

// 5 percent too much where the direction is steep.
TEST_F(TestFilesOfDevice, RejectAWrongWeight) {
  write("mine.glsl", ownBsdf(kCosine, "m.albedo * (wo.z > 0.9 ? 1.05 : 1.0)"));
  EXPECT_EQ(student().code, 5);
  EXPECT_EQ(chiSquared().code, 0);
}

TEST_F(TestFilesOfDevice, RejectAMissingFactor) {
  write("mine.glsl", ownBsdf(kCosine, "vec3(1.0)"));
  EXPECT_EQ(student().code, 5);
}

TEST_F(TestFilesOfDevice, RejectSamplesThatAreNotFinite) {
  write("mine.glsl", ownBsdf(kCosine, "m.albedo / (numbers.y < 1e-3 ? 0.0 : 1.0)"));
  const Outcome outcome = student();
  EXPECT_EQ(outcome.code, 5);
  EXPECT_TRUE(says(outcome, "samples are not finite")) << outcome.out;
}

// Inside a closed box that emits 1 and reflects a half, light from all bounces is 2.
const std::string kFurnace =
    "<scene><integrator type=\"path_mis\"/><camera type=\"perspective\">"
    "<integer name=\"width\" value=\"3\"/><integer name=\"height\" value=\"2\"/></camera>"
    "<mesh type=\"obj\"><string name=\"filename\" value=\"box.obj\"/><emitter type=\"area\">"
    "<color name=\"radiance\" value=\"1 1 1\"/></emitter></mesh></scene>";

TEST_F(TestFilesOfDevice, TestTheMeanOfScenesOnBothSides) {
  // A cube whose sides face inwards.
  write("box.obj",
        "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
        "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n");
  const std::string start = "<test type=\"ttest\"><string name=\"references\" value=\"";
  for (const std::string where : {"--device $device", "--reference"}) {
    const Outcome right = run(start + "2\"/>" + kFurnace + "</test>", where);
    EXPECT_EQ(right.code, 0) << right.out << right.err;
    EXPECT_TRUE(says(right, "Testing scene 1 (path_mis), 101400 samples")) << right.out;
    EXPECT_EQ(run(start + "2.02\"/>" + kFurnace + "</test>", where).code, 5);
  }
}

// Floats cannot tell the samples of such a pixel apart where depths differ much, and need not.
TEST_F(TestFilesOfDevice, TestScenesSeenThroughASinglePixel) {
  write("floor.obj", "v -9 0 -9\nv 9 0 -9\nv 9 0 9\nv -9 0 9\nf 4 3 2 1\n");
  write("cellar.obj", "v -9 -99 -9\nv 9 -99 -9\nv 0 -99 9\nf 3 2 1\n");
  const Outcome outcome =
      run("<test type=\"ttest\"><string name=\"references\" value=\"0.715160\"/><scene>"
          "<integrator type=\"normals\"/><camera type=\"perspective\"><transform name=\"toWorld\">"
          "<lookat origin=\"0, 0.01, 0\" target=\"0, 0, 0\" up=\"0, 0, 1\"/></transform>"
          "<float name=\"fov\" value=\"1e-3\"/><integer name=\"width\" value=\"1\"/>"
          "<integer name=\"height\" value=\"1\"/></camera><mesh type=\"obj\">"
          "<string name=\"filename\" value=\"floor.obj\"/></mesh><mesh type=\"obj\">"
          "<string name=\"filename\" value=\"cellar.obj\"/></mesh></scene></test>");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
}

// A power of 4 pi at a distance of 2 and of 3: 1/4 and 1/9.
TEST_F(TestFilesOfDevice, TestLightsWithoutExtent) {
  const std::string light =
      "<emitter type=\"point\"><point name=\"position\" value=\"0 0 -1\"/>"
      "<color name=\"power\" value=\"12.566371 12.566371 12.566371\"/></emitter></test>";
  const std::string start =
      "<test type=\"ttest\"><string name=\"distances\" value=\"1, 2\"/>"
      "<string name=\"references\" value=\"0.25 ";
  const Outcome right = run(start + "0.111111\"/>" + light, "--dialect eth");
  EXPECT_EQ(right.code, 0) << right.out << right.err;
  EXPECT_TRUE(says(right, "Passed 2/2 tests.")) << right.out;
  EXPECT_EQ(run(start + "0.1112\"/>" + light, "--dialect eth").code, 5);
}

TEST_F(TestFilesOfDevice, TheReferenceDoesNotRunAUsersCode) {
  write("mine.glsl", ownBsdf(kCosine, "m.albedo"));
  const Outcome outcome = run(std::string("<test type=\"chi2test\">") + kOwn, "--reference");
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(lines(outcome.err), 1) << outcome.err;
}

}  // namespace
}  // namespace laver::test
