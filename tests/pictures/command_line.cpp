// The binary as a user runs it: exit codes, one-line errors, files.
#include "pictures/command_line.h"

#include <nlohmann/json.hpp>
#include <tuple>

#include "image/io.h"

namespace laver::test {
namespace {

TEST_F(CommandLine, RendersTheFirstSceneOfTheHandOut) {
  write("test.xml", kFirstScene);
  const Outcome run = laver("test.xml --nogui --device $device");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.err.find("test.xml:3:"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("warning"), std::string::npos);
  EXPECT_NE(run.out.find("Configuration: Scene[\n  integrator = NormalIntegrator["),
            std::string::npos)
      << run.out;
  EXPECT_NE(run.out.find("outputSize = [1280, 720]"), std::string::npos);
  EXPECT_NE(run.out.find("Rendering .. done. (took "), std::string::npos);
  EXPECT_NE(run.out.find("Writing a 1280x720 OpenEXR file to \"test.exr\""), std::string::npos);
  const Image image = readExr((folder_ / "test.exr").string());
  EXPECT_EQ(image.width, 1280);
  EXPECT_EQ(image.height, 720);
  for (const float v : image.pixels) ASSERT_EQ(v, 0.0F);
  EXPECT_TRUE(fs::exists(folder_ / "test.png"));
}

TEST_F(CommandLine, OverridesReachThePictureAndItsAttributes) {
  write("test.xml", kFirstScene);
  const Outcome run = laver(
      "test.xml --device $device --quiet --size 40x30 --crop 3,4,13,24 --spp 2 --seed 9 -o a.exr "
      "--stats=s.json");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out, "");
  const Image image = readExr((folder_ / "a.exr").string());
  EXPECT_EQ(image.width, 10);
  EXPECT_EQ(image.height, 20);
  const auto stats = nlohmann::json::parse(contents(folder_ / "s.json"));
  EXPECT_EQ(stats["samples"]["total"], 10 * 20 * 2);
  EXPECT_TRUE(stats["seconds"].contains("trace"));
  EXPECT_FALSE(fs::exists(folder_ / "test.exr"));
}

TEST_F(CommandLine, ACropKeepsItsPlaceOnTheFilm) {
  write("test.xml", kFirstScene);
  const std::string render = "test.xml --device $device --quiet --size 64x48 -o ";
  ASSERT_EQ(laver(render + "a.exr --crop 10,5,40,30").code, 0);
  ASSERT_EQ(laver(render + "b.exr").code, 0);
  const Image crop = readExr(path("a.exr"));
  EXPECT_EQ(crop.window, (FilmWindow{10, 5, 64, 48}));
  EXPECT_EQ(crop.width, 30);
  const Outcome run = laver("compare a.exr b.exr --tolerance 0");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(run.out.find("compared where both have pixels: 30x25 from (10, 5)\n"), 0U) << run.out;
}

TEST_F(CommandLine, ReferenceNeedsNoDriver) {
  write("test.xml", kFirstScene);
  const std::string none = "VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent";
  EXPECT_EQ(laver("test.xml --size 8x8 --reference --quiet", none).code, 0);
  const Outcome run = laver("test.xml --size 8x8 --quiet", none);
  EXPECT_EQ(run.code, 4);
  EXPECT_EQ(lines(run.err), 2) << run.err;  // the scene's warning and the error
  EXPECT_NE(run.err.find("laver: "), std::string::npos);
}

TEST_F(CommandLine, SchemaIsTextOrJson) {
  const Outcome text = laver("schema"), json = laver("schema --json");
  EXPECT_EQ(text.code, 0) << text.err;
  EXPECT_NE(text.out.find("\n    sampleCount  integer    1\n"), std::string::npos) << text.out;
  EXPECT_EQ(json.code, 0) << json.err;
  EXPECT_EQ(nlohmann::json::parse(json.out)["elements"][0]["tag"], "integrator");
}

TEST_F(CommandLine, UsageErrorsAreOneLineAndExitTwo) {
  write("test.xml", kFirstScene);
  for (const char* arguments : {"",
                                "--nonsense",
                                "test.xml --size 12",
                                "test.xml --size 12x",
                                "test.xml --size axb",
                                "test.xml --crop 1,2,3",
                                "test.xml --crop 0,0,5000,2 --device $device",
                                "test.xml --crop 4,4,4,8 --device $device",
                                "test.xml --size 0x0",
                                "test.xml -o ''",
                                "test.xml --spp 0",
                                "test.xml --spp -3",
                                "test.xml --integrator vol_path",
                                "test.xml --sampler halton",
                                "test.xml --filter sinc",
                                "test.xml -o picture.jpg --device $device",
                                "test.xml --device $device --traversal magic",
                                "compare",
                                "compare a.exr",
                                "compare a.exr b.exr",
                                "explain",
                                "compare --explain test.xml"}) {
    const Outcome run = laver(arguments);
    EXPECT_EQ(run.code, 2) << arguments << ": " << run.err;
    const int warnings = run.err.find("warning") == std::string::npos ? 0 : 1;
    EXPECT_EQ(lines(run.err), 1 + warnings) << arguments << ": " << run.err;
  }
}

TEST_F(CommandLine, AScenePipedInNeedsAnOutput) {
  write("test.xml", kFirstScene);
  const std::string rest = " --reference --size 8x8 --quiet --integrator depth";
  for (const char* where : {"/dev/stdin", "/proc/self/fd/0", "/dev/fd/0"}) {
    const Outcome run = laver(where + rest, "", "< test.xml");
    EXPECT_EQ(run.code, 2) << run.err;
    EXPECT_NE(run.err.find("laver: -o OUT.exr is needed"), std::string::npos) << run.err;
    EXPECT_EQ(files(), (std::set<std::string>{"test.xml"}));
  }
  EXPECT_EQ(laver("/dev/stdin -o a.exr" + rest, "cat test.xml |").code, 0);
  EXPECT_EQ(laver("/dev/stdin -o b.exr" + rest, "", "< test.xml").code, 0);
  EXPECT_EQ(files(), (std::set<std::string>{"test.xml", "a.exr", "a.png", "b.exr", "b.png"}));
}

TEST_F(CommandLine, FilesOfTheSceneAreNotReplaced) {
  writeExr(path("sky.exr"), rgbImage(4, 2));
  const std::string before = contents(folder_ / "sky.exr");
  write("test.xml",
        "<scene><integrator type=\"direct_whitted\"/><emitter type=\"envmap\">"
        "<string name=\"filename\" value=\"sky.exr\"/></emitter></scene>");
  const Outcome run = laver("test.xml --reference --size 8x8 --quiet -o ./sky.exr");
  EXPECT_EQ(run.code, 2) << run.err;
  EXPECT_NE(run.err.find("the scene reads it"), std::string::npos) << run.err;
  EXPECT_EQ(contents(folder_ / "sky.exr"), before);
}

TEST_F(CommandLine, SceneErrorsExitThreeAndTouchNoOutput) {
  write("bad.xml",
        "<scene>\n  <integrator type=\"normals\"/>\n  <camera type=\"fisheye\"/>\n</scene>\n");
  write("bad.exr", "precious");
  const Outcome run = laver("bad.xml --device $device");
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err.rfind("bad.xml:3:4: error: ", 0), 0U) << run.err;
  EXPECT_EQ(contents(folder_ / "bad.exr"), "precious");
  EXPECT_EQ(laver("missing.xml --device $device").code, 3);
}

TEST_F(CommandLine, AnUnknownDeviceExitsFour) {
  write("test.xml", kFirstScene);
  const Outcome run = laver("test.xml --device nosuchdevice --quiet");
  EXPECT_EQ(run.code, 4);
  EXPECT_NE(run.err.find("nosuchdevice"), std::string::npos);
}

TEST_F(CommandLine, AnOutputThatCannotBeWrittenExitsOne) {
  write("test.xml", kFirstScene);
  EXPECT_EQ(laver("test.xml --device $device --size 8x8 --quiet -o nofolder/a.exr").code, 1);
  fs::create_directory(folder_ / "folder.exr");
  EXPECT_EQ(laver("test.xml --device $device --size 8x8 --quiet -o folder.exr").code, 1);
}

TEST_F(CommandLine, CompareMeasuresAndJudges) {
  Image image = rgbImage(20, 10);
  writeExr((folder_ / "a.exr").string(), image);
  image.at(3, 4, 1) = 0.25F;
  writeExr((folder_ / "b.exr").string(), image);
  EXPECT_EQ(laver("compare a.exr a.exr --tolerance 0").code, 0);
  EXPECT_EQ(laver("compare a.exr b.exr").code, 0);
  EXPECT_EQ(laver("compare a.exr b.exr --tolerance 0.3").code, 0);
  const Outcome beyond = laver("compare a.exr b.exr --tolerance 0.2");
  EXPECT_EQ(beyond.code, 5);
  EXPECT_NE(beyond.out.find("0.25"), std::string::npos) << beyond.out;
  EXPECT_EQ(laver("compare a.exr b.exr --tolerance 0.02 --metric rmse").code,
            0);  // 0.25 / sqrt(200)
  EXPECT_EQ(laver("compare a.exr b.exr --tolerance 0.017 --metric rmse").code, 5);
  // One of 200 pixels.
  EXPECT_EQ(laver("compare a.exr b.exr --tolerance 0.2 --max-share 0.005").code, 0);
  EXPECT_EQ(laver("compare a.exr b.exr --tolerance 0.2 --max-share 0.004").code, 5);
  EXPECT_EQ(laver("compare a.exr b.exr --max-share 0.004").code, 2);
  // Far more is seen than the one pixel, on average less than 0.1.
  EXPECT_EQ(laver("compare a.exr b.exr --tolerance 0.1 --metric flip").code, 0);
  EXPECT_EQ(laver("compare a.exr b.exr --tolerance 0.001 --metric ldrflip").code, 5);
  const Outcome json = laver("compare a.exr b.exr --tolerance 0.2 --metric flip --json");
  const auto all = nlohmann::json::parse(json.out);
  EXPECT_EQ(all["within"], json.code == 0);
  EXPECT_EQ(all["channels"]["G"]["max"], 0.25);
  EXPECT_GT(all["flip"]["mean"], 0.0);
  writeExr((folder_ / "c.exr").string(), rgbImage(21, 10));
  const Outcome sizes = laver("compare a.exr c.exr");
  EXPECT_EQ(sizes.code, 2);
  EXPECT_EQ(lines(sizes.err), 1);
}

TEST_F(CommandLine, ExplainsAScene) {
  write("t.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
  write("test.xml",
        "<scene><integrator type=\"depth\"/><camera type=\"perspective\">"
        "<integer name=\"width\" value=\"40\"/><integer name=\"height\" value=\"30\"/>"
        "<transform name=\"toWorld\"><lookat origin=\"0,0,4\" target=\"0,0,0\" up=\"0,1,0\"/>"
        "</transform></camera><mesh type=\"obj\"><string name=\"filename\" value=\"t.obj\"/>"
        "</mesh></scene>");
  const Outcome run = laver("explain test.xml --device $device");
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_NE(run.out.find("other hit: 0"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("unexplained: 0\n"), std::string::npos) << run.out;
  const Outcome none = laver("explain none.xml");
  EXPECT_EQ(none.code, 3);
  EXPECT_EQ(lines(none.err), 1) << none.err;
}

TEST_F(CommandLine, CompareDrawsTheDifference) {
  Image a = rgbImage(20, 10), b = a;
  a.channels[2] = b.channels[0] = "depth.Z";  // b's channels are Z G R, a's R G Z
  b.channels[2] = "R";
  b.at(3, 4, 1) = 0.25F;
  b.at(5, 6, 0) = 1e-6F;
  writeExr(path("a.exr"), a);
  writeExr(path("b.exr"), b);
  EXPECT_EQ(laver("compare a.exr b.exr --out new/folder --tolerance 0.1").code, 5);
  const Image difference = readExr(path("new/folder/difference.exr"));
  Image expected = readExr(path("a.exr"));  // its channels, in the order of reading
  for (const auto& [x, y, name, value] :
       {std::tuple(3, 4, "G", -0.25F), std::tuple(5, 6, "depth.Z", -1e-6F)}) {
    const auto c = std::find(expected.channels.begin(), expected.channels.end(), name);
    expected.at(x, y, static_cast<std::size_t>(c - expected.channels.begin())) = value;
  }
  EXPECT_EQ(difference.channels, expected.channels);
  EXPECT_EQ(difference.pixels, expected.pixels);
  EXPECT_GT(fs::file_size(path("new/folder/difference.png")), 100U);

  const std::string old = contents(path("new/folder/difference.exr"));
  writeExr(path("c.exr"), rgbImage(20, 10));
  const Outcome channels = laver("compare a.exr c.exr --out new/folder");
  EXPECT_EQ(channels.code, 2);
  EXPECT_EQ(lines(channels.err), 1) << channels.err;
  EXPECT_EQ(contents(path("new/folder/difference.exr")), old);
  const Outcome noFolder = laver("compare a.exr b.exr --out a.exr");
  EXPECT_EQ(noFolder.code, 1);
  EXPECT_EQ(lines(noFolder.err), 1) << noFolder.err;
}

TEST_F(CommandLine, NeedsNoFolderToKeepKernelsIn) {
  write("scene.xml", "<scene><integrator type=\"normals\"/><camera type=\"perspective\"/></scene>");
  for (const char* variables : {"env -u HOME -u XDG_CACHE_HOME",
                                "MESA_SHADER_CACHE_DISABLE=true XDG_CACHE_HOME=/proc/none"}) {
    const Outcome run = laver("scene.xml --device $device -q --size 8x8", variables);
    EXPECT_EQ(run.code, 0) << variables;
    EXPECT_EQ(run.err, "") << variables;
  }
}

TEST_F(CommandLine, DevicesListsTheCpuAndItsLimits) {
  const Outcome run = laver("devices");
  EXPECT_EQ(run.code, 0) << run.err;
  for (const char* part : {"0: ", " (default)\n", "CPU", "driver", "subgroup size", "traversal",
                           "maxStorageBufferRange", "memory heaps"})
    EXPECT_NE(run.out.find(part), std::string::npos) << part << ":\n" << run.out;
  const Outcome none =
      laver("devices", "VK_ICD_FILENAMES=/nonexistent VK_DRIVER_FILES=/nonexistent");
  EXPECT_EQ(none.code, 4);
  EXPECT_EQ(none.out, "");
  EXPECT_EQ(lines(none.err), 1) << none.err;
}

}  // namespace
}  // namespace laver::test
