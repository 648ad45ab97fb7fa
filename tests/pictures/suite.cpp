// `laver test`: scenes with expected pictures.
#include <pugixml.hpp>
#include <regex>

#include "image/io.h"
#include "pictures/command_line.h"

namespace laver::test {
namespace {

constexpr const char* kNoDevice = "VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent";

std::string sceneOf(const std::string& integrator, const std::string& radius = "1") {
  return "<scene><integrator type=\"" + integrator +
         "\"/><camera type=\"perspective\"><integer name=\"width\" value=\"12\"/>"
         "<integer name=\"height\" value=\"8\"/><transform name=\"toWorld\">"
         "<lookat origin=\"0,0,4\" target=\"0,0,0\" up=\"0,1,0\"/></transform></camera>"
         "<mesh type=\"sphere\"><float name=\"radius\" value=\"" +
         radius + "\"/></mesh></scene>";
}

constexpr const char* kDiffuse =
    "<bsdf type=\"diffuse\"><color name=\"albedo\" value=\"0.5 0.5 0.5\"/></bsdf></test>";

std::string testOf(const std::string& reference) {
  return "<test type=\"ttest\"><string name=\"angles\" value=\"0\"/><string name=\"references\" "
         "value=\"" +
         reference + "\"/>" + kDiffuse;
}

/// Without the seconds of each line.
std::string timeless(const std::string& text) {
  return std::regex_replace(text, std::regex(" [0-9]+\\.[0-9]+ s"), "");
}

int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

class Suite : public CommandLine {
 protected:
  /// A scene with a picture that it has had before.
  void writeTest(const std::string& stem, const std::string& before, const std::string& now) {
    write("t/" + stem + ".xml", before);
    ASSERT_EQ(laver("t/" + stem + ".xml --reference -q -o t/" + stem + ".expected.exr").code, 0);
    write("t/" + stem + ".xml", now);
  }
  /// One of each kind, of which `bad`, `broken` and `h/false` fail.
  void writeTests() {
    writeTest("bad", sceneOf("normals"), sceneOf("normals", "0.5"));
    writeTest("good", sceneOf("depth"), sceneOf("depth"));
    writeTest("broken", sceneOf("depth"), "<scene><integrator type=\"depht\"/></scene>");
    write("t/h/true.xml", testOf("0.5"));
    write("t/h/false.xml", testOf("0.6"));
  }
};

TEST_F(Suite, ReportsEveryTestAndExitsFive) {
  writeTests();
  const Outcome run = laver("test t --reference --junit j.xml --html h.html");
  EXPECT_EQ(run.code, 5) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(lines(run.out), 6) << run.out;
  EXPECT_EQ(run.out.rfind("failed   bad.xml  ", 0), 0U) << run.out;
  EXPECT_NE(run.out.find("\nfailed   broken.xml  "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("s: t/broken.xml:1:9: error: laver has no integrator"), std::string::npos)
      << run.out;
  EXPECT_NE(timeless(run.out).find("\npassed   good.xml   p99 0, tolerance 0.001\n"),
            std::string::npos)
      << timeless(run.out);
  EXPECT_NE(run.out.find("hypotheses are rejected: Passed 0/1 tests."), std::string::npos);
  EXPECT_NE(run.out.find("\npassed   h/true.xml  "), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("\n2 passed, 3 failed, 0 skipped\n"), std::string::npos) << run.out;

  pugi::xml_document junit;
  ASSERT_TRUE(junit.load_file((folder_ / "j.xml").c_str()));
  EXPECT_EQ(junit.child("testsuites").attribute("tests").as_int(), 5);
  EXPECT_EQ(junit.child("testsuites").attribute("failures").as_int(), 3);
  // Three pictures of `bad` and of `good`; the others have none.
  EXPECT_EQ(countOf(contents(folder_ / "h.html"), "src=\"data:image/png;base64,iVBOR"), 6);
}

TEST_F(Suite, PassesOnADeviceWhatTheReferenceExpects) {
  writeTest("a", sceneOf("normals"), sceneOf("normals"));
  const Outcome run = laver("test t --device $device");
  EXPECT_EQ(run.code, 0) << run.out << run.err;
  EXPECT_NE(run.out.find("1 passed, 0 failed, 0 skipped\n"), std::string::npos) << run.out;
}

TEST_F(Suite, SeveralJobsPrintTheSame) {
  writeTests();
  const Outcome one = laver("test t --reference"), three = laver("test t --reference --jobs 3");
  EXPECT_EQ(timeless(three.out), timeless(one.out));
  EXPECT_EQ(three.code, 5);
}

TEST_F(Suite, AcceptWritesExpectedPicturesAndSaysWhy) {
  writeTest("bad", sceneOf("normals"), sceneOf("normals", "0.5"));
  writeTest("good", sceneOf("depth"), sceneOf("depth"));
  writeTest("size", sceneOf("depth"), sceneOf("depth"));
  write("t/size.test.json", "{\"size\": \"5x4\"}");
  write("t/new.xml", sceneOf("normals"));
  write("t/new.test.json", "{\"samples\": 2}");
  const std::string good = contents(folder_ / "t/good.expected.exr");
  const Outcome without = laver("test t --reference");
  EXPECT_EQ(without.code, 5);
  EXPECT_NE(without.out.find("no expected picture; --accept writes one"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "t/new.expected.exr"));

  const Outcome accept = laver("test t --reference --accept");
  EXPECT_EQ(accept.code, 0) << accept.out << accept.err;
  EXPECT_NE(accept.out.find("replaced, before: p99 "), std::string::npos) << accept.out;
  EXPECT_NE(accept.out.find("replaced, before: the pictures differ in size"), std::string::npos)
      << accept.out;
  EXPECT_NE(accept.out.find("  new\n"), std::string::npos) << accept.out;
  EXPECT_NE(accept.out.find("p99 0, tolerance 0.001  unchanged\n"), std::string::npos);
  EXPECT_EQ(contents(folder_ / "t/good.expected.exr"), good);
  EXPECT_EQ(readExr(path("t/new.expected.exr")).width, 12);
  const Outcome again = laver("test t --reference");
  EXPECT_EQ(again.code, 0) << again.out;
}

TEST_F(Suite, AcceptDoesNotHideOtherFailures) {
  writeTests();
  const Outcome accept = laver("test t --reference --accept");
  EXPECT_EQ(accept.code, 5);
  EXPECT_NE(accept.out.find("3 passed, 2 failed, 0 skipped\n"), std::string::npos) << accept.out;
}

TEST_F(Suite, SettingsAreThoseOfTheRenderAndOfTheBound) {
  writeTest("a", sceneOf("normals"), sceneOf("normals", "0.99"));
  EXPECT_EQ(laver("test t --reference").code, 5);
  for (const char* loose : {"{\"tolerance\": 0.6}", "{\"metric\": \"rmse\", \"tolerance\": 0.2}",
                            "{\"metric\": \"flip\", \"tolerance\": 0.2}", "{\"maxShare\": 0.96}"}) {
    write("t/a.test.json", loose);
    const Outcome run = laver("test t --reference");
    EXPECT_EQ(run.code, 0) << loose << run.out;
  }
  write("t/a.test.json", "{\"tolerance\": 0.6,\n  \"layers\": [\"depth\"]}");
  const Outcome layers = laver("test t --reference");
  EXPECT_EQ(layers.code, 5);
  EXPECT_NE(layers.out.find("the pictures differ in channels"), std::string::npos) << layers.out;
  write("t/a.test.json", "{\"tolerance\": 0.6,\n  \"layers\": [\"deph\"]}");
  const Outcome wrong = laver("test t --reference");
  EXPECT_EQ(wrong.code, 5);
  EXPECT_NE(wrong.out.find("t/a.test.json:2:13: error: \"layers\": "), std::string::npos)
      << wrong.out;
}

// Openness over a ground with an occluder, in front of a pixel or two of background.
std::string noisyScene(const std::string& length) {
  return "<scene><integrator type=\"av\"><float name=\"length\" value=\"" + length +
         "\"/></integrator><camera type=\"perspective\"><rfilter type=\"box\"/>"
         "<integer name=\"width\" value=\"24\"/><integer name=\"height\" value=\"16\"/>"
         "<transform name=\"toWorld\"><lookat origin=\"0,0,4\" target=\"0,0,0\" up=\"0,1,0\"/>"
         "</transform></camera><mesh type=\"sphere\"/><mesh type=\"sphere\"><point name=\"center\" "
         "value=\"0,-3,0\"/><float name=\"radius\" value=\"2\"/></mesh></scene>";
}

// Pictures of other seeds and numbers of samples, and one whose openness has changed.
TEST_F(Suite, NoiseIsNoDifferenceButAnotherExpectationIs) {
  write("t/a.xml", noisyScene("3"));
  ASSERT_EQ(laver("t/a.xml --reference -q --layers variance --spp 256 -o t/a.expected.exr").code,
            0);
  write("t/a.test.json", "{\"metric\": \"noise\", \"seed\": 7, \"samples\": 64}");
  const Outcome same = laver("test t --device $device --html h.html");
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_NE(same.out.find("  noise: 100 % of the pixels agree, 99.75 % must; mean "),
            std::string::npos)
      << same.out;
  EXPECT_EQ(countOf(contents(folder_ / "h.html"), "src=\"data:image/png;base64,iVBOR"), 3);
  write("t/a.xml", noisyScene("0.5"));
  const Outcome other = laver("test t --device $device");
  EXPECT_EQ(other.code, 5) << other.out;
  EXPECT_NE(other.out.find("the least likely pixel is ("), std::string::npos) << other.out;
  EXPECT_EQ(laver("test t --device $device --accept").code, 0);
  EXPECT_EQ(laver("test t --device $device").code, 0);
}

TEST_F(Suite, NoiseNeedsVariancesInTheExpectedPicture) {
  write("t/a.test.json", "{\"metric\": \"noise\", \"samples\": 2}");
  writeTest("a", noisyScene("3"), noisyScene("3"));
  const Outcome none = laver("test t --reference");
  EXPECT_EQ(none.code, 5);
  EXPECT_NE(none.out.find("variance.R is missing: render with --layers variance"),
            std::string::npos)
      << none.out;
  fs::remove(folder_ / "t/a.expected.exr");
  const Outcome png = laver("test t --reference");
  EXPECT_EQ(png.code, 5);
  EXPECT_NE(png.out.find("the metric noise needs an expected EXR file"), std::string::npos)
      << png.out;
}

TEST_F(Suite, ATestThatIsNotDoneInTimeFails) {
  writeTest("a", sceneOf("normals"), sceneOf("normals"));
  write("t/a.test.json", "{\"samples\": 1000000, \"size\": \"512x512\"}");
  const Outcome run = laver("test t --reference --timeout 0.5");
  EXPECT_EQ(run.code, 5) << run.err;
  EXPECT_NE(run.out.find("s: not done after 0.5 s (--timeout)\n"), std::string::npos) << run.out;
}

TEST_F(Suite, AnExpectedPictureMayBeAPng) {
  write("t/a.xml", sceneOf("normals"));
  ASSERT_EQ(laver("t/a.xml --reference -q -o t/a.expected.exr").code, 0);
  fs::remove(folder_ / "t/a.expected.exr");
  EXPECT_EQ(laver("test t --reference").code, 0);
  write("t/a.xml", sceneOf("normals", "0.7"));
  EXPECT_EQ(laver("test t --reference").code, 5);
  EXPECT_EQ(laver("test t --reference --accept").code, 0);
  EXPECT_EQ(laver("test t --reference").code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "t/a.expected.exr"));
}

TEST_F(Suite, WithoutADeviceTestsFailOrAreCountedAsSkipped) {
  writeTest("a", sceneOf("normals"), sceneOf("normals"));
  const Outcome run = laver("test t --junit j.xml", kNoDevice);
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(lines(run.err), 1) << run.err;
  EXPECT_EQ(run.err.rfind("laver: no Vulkan device can be used: ", 0), 0U) << run.err;
  const Outcome skip = laver("test t --junit j.xml --allow-skip", kNoDevice);
  EXPECT_EQ(skip.code, 0) << skip.err;
  EXPECT_NE(skip.out.find("0 passed, 0 failed, 1 skipped\n"), std::string::npos) << skip.out;
  EXPECT_NE(contents(folder_ / "j.xml").find("<skipped message=\"no Vulkan device"),
            std::string::npos);
  EXPECT_EQ(laver("test t --device nosuchdevice").code, 4);
  EXPECT_EQ(laver("test t --reference", kNoDevice).code, 0);
}

TEST_F(Suite, AFolderWithoutTestsIsAnError) {
  write("t/a.xml", sceneOf("normals"));
  const Outcome run = laver("test t --reference");
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.err.rfind("laver: no test in \"t\": ", 0), 0U) << run.err;
  EXPECT_EQ(lines(run.err), 1);
  EXPECT_EQ(laver("test none --reference").code, 2);
}

TEST_F(Suite, ReportsThatCannotBeWrittenAreFoundBeforeTheTests) {
  writeTest("a", sceneOf("normals"), sceneOf("normals"));
  const Outcome run = laver("test t --reference --html none/h.html");
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.out, "");
}

// Whatever ends the process that renders, as a crash in a driver does.
TEST_F(Suite, AProcessThatIsKilledIsOneFailedTest) {
  writeTest("a", sceneOf("normals"), sceneOf("normals"));
  writeTest("b", sceneOf("normals"), sceneOf("normals"));
  write("t/b.test.json", "{\"samples\": 1000000, \"size\": \"512x512\"}");
  // The processor time of each process in seconds; SIGXCPU ends the one that exceeds it.
  const Outcome run = laver("test t --reference", "ulimit -t 5;");
  EXPECT_EQ(run.code, 5) << run.err;
  EXPECT_NE(run.out.find("passed   a.xml"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("laver was ended by signal "), std::string::npos) << run.out;
}

TEST_F(Suite, AnInterruptionEndsTheRun) {
  writeTest("a", sceneOf("normals"), sceneOf("normals"));
  writeTest("b", sceneOf("normals"), sceneOf("normals"));
  write("t/b.test.json", "{\"samples\": 1000000, \"size\": \"512x512\"}");
  Child child(folder_, {"test", "t", "--reference", "--junit", "j.xml", "-t", "1"});
  while (contents(folder_ / "out.txt").find("a.xml") == std::string::npos && !child.ended())
    ::usleep(2000);
  child.send(SIGTERM);
  EXPECT_EQ(child.wait(), 143);
  EXPECT_NE(contents(folder_ / "err.txt").find("interrupted after 1 of 2 tests"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "j.xml"));
}

}  // namespace
}  // namespace laver::test
