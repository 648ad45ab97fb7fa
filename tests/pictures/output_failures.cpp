// Outputs that cannot be written: one line, exit code 1, and the old picture as it was.
#include "image/io.h"
#include "pictures/child.h"
#include "pictures/command_line.h"
#include "pictures/harness.h"

namespace laver::test {
namespace {

constexpr const char* kRender =
    "test.xml --reference --size 40x30 --integrator depth -o a.exr ";  // a scene without warnings

class OutputFailure : public CommandLine {
 protected:
  OutputFailure() {
    write("test.xml",
          "<scene><integrator type=\"normals\"/><camera type=\"perspective\"/></scene>\n");
    write("a.exr", "old");
    write("a.png", "old too");
    before_ = files();
  }
  void expectRefused(const Outcome& run, const std::string& reason) {
    EXPECT_EQ(run.code, 1) << run.err;
    EXPECT_EQ(lines(run.err), 1) << run.err;
    EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
    EXPECT_EQ(contents(path("a.exr")), "old");
    EXPECT_EQ(contents(path("a.png")), "old too");
    EXPECT_EQ(files(), before_);
  }
  std::set<std::string> before_;
};

TEST_F(OutputFailure, StandardOutputIsFullOrClosed) {
  Image picture = rgbImage(4, 4);
  writeExr(path("b.exr"), picture);
  before_ = files();
  for (const char* where : {">/dev/full", ">&-"}) {
    for (const std::string& arguments :
         {std::string(kRender), std::string("compare b.exr b.exr --out folder"),
          std::string("devices"), std::string("--help"), std::string("--version")})
      expectRefused(laver(arguments, "", where), "standard output cannot be written");
  }
}

TEST_F(OutputFailure, StandardOutputIsAClosedPipe) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(::pipe(ends), 0);
  ::close(ends[0]);
  const Descriptor pipe(ends[1]);
  Child child(folder_, {"test.xml", "--reference", "--size", "8x8", "-o", "a.exr"}, pipe.get());
  const int code = child.wait();
  expectRefused({code, "", contents(folder_ / "err.txt")}, "standard output cannot be written");
}

TEST_F(OutputFailure, QuietNeedsNoStandardOutput) {
  const Outcome run = laver(std::string(kRender) + "--quiet", "", ">&- 2>&- <&-");
  EXPECT_EQ(run.code, 0);
  // No file got the number of a closed descriptor and what is printed to it.
  EXPECT_EQ(readExr(path("a.exr")).width, 40);
  EXPECT_EQ(files(), before_);
}

TEST_F(OutputFailure, TheDiskIsFull) {
  // A limit on file sizes, in blocks of at least 512 bytes, ends writing half-way.
  const std::string scene = (scenesFolder() / "curved-normals.xml").string();
  expectRefused(laver(scene + " --reference --size 64x64 --spp 1 --quiet -o a.exr", "ulimit -f 1;"),
                "a.exr\": File too large");
}

// Drivers crash where they get no memory; that is an error, too.
TEST_F(OutputFailure, AddressSpaceIsShort) {
  const std::string scene = (scenesFolder() / "cornell-two-lights.xml").string();
  for (int mebibytes = 150; mebibytes <= 1050; mebibytes += 50) {
    fs::remove(path("a.exr"));
    // Kernels are compiled in each.
    const Outcome run = laver(scene + " --device $device --spp 1 --quiet -o a.exr",
                              "export XDG_CACHE_HOME=cache" + std::to_string(mebibytes) +
                                  "; ulimit -v " + std::to_string(1024 * mebibytes) + ";");
    EXPECT_LT(run.code, 128) << mebibytes << " MiB: " << run.err;
    EXPECT_EQ(run.code == 0, fs::exists(path("a.exr"))) << mebibytes << " MiB: " << run.err;
    EXPECT_EQ(run.code == 0, run.err.empty()) << mebibytes << " MiB: " << run.err;
  }
}

TEST_F(OutputFailure, TheStatisticsFileCannotBeWritten) {
  const Outcome run = laver(std::string(kRender) + "--quiet --stats=/dev/full");
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(run.err, "laver: /dev/full: cannot be written\n");
  write("stats.json", "old");
  laver(std::string(kRender) + "--quiet --stats=stats.json", "ulimit -f 0;");
  EXPECT_EQ(contents(path("stats.json")), "old");
}

TEST_F(OutputFailure, TheFolderTakesNoFiles) {
  const std::string render = "test.xml --reference --size 8x8 --quiet -o ";
  expectRefused(laver(render + "test.xml/a.exr"), "test.xml/a.exr\": Not a directory");
  expectRefused(laver(render + "nowhere/a.exr"), "nowhere/a.exr\": No such file or directory");
  expectRefused(laver(render + "/proc/a.exr"), "/proc/a.exr\": ");
}

TEST_F(OutputFailure, ALinkIsFollowedAndStays) {
  fs::remove(path("a.exr"));
  fs::create_directory(path("elsewhere"));
  fs::create_symlink("elsewhere/b.exr", path("a.exr"));
  for (int i = 0; i < 2; ++i) {  // at first the target does not exist
    const Outcome run = laver(std::string(kRender) + "--quiet");
    EXPECT_EQ(run.code, 0) << run.err;
    EXPECT_TRUE(fs::is_symlink(path("a.exr")));
    EXPECT_EQ(readExr(path("elsewhere/b.exr")).width, 40);
    EXPECT_EQ(std::distance(fs::directory_iterator(path("elsewhere")), {}), 1);
  }
  EXPECT_GT(fs::file_size(path("a.png")), 50U);
}

}  // namespace
}  // namespace laver::test
