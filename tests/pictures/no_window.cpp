// Behaviour without a window: no display, or a build without GLFW and Dear ImGui.
#include "image/io.h"
#include "pictures/command_line.h"

namespace laver::test {
namespace {

TEST_F(CommandLine, WithoutADisplayTheFilesAreStillWritten) {
  write("a.xml", "<scene><integrator type=\"normals\"/><camera type=\"perspective\"/></scene>\n");
  const Outcome run = laver("a.xml --gui --reference --size 8x8 -q", "env -u DISPLAY");
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(lines(run.err), 1) << run.err;
  EXPECT_EQ(run.err.find("laver: warning: no window: "), 0U) << run.err;
  EXPECT_EQ(files(), (std::set<std::string>{"a.xml", "a.exr", "a.png"}));
  const Outcome none = laver("a.xml --no-gui --gui --reference --size 8x8 -q", "env -u DISPLAY");
  EXPECT_EQ(none.code, 0);
  EXPECT_EQ(none.err, "");
}

TEST_F(CommandLine, WithoutADisplayTheViewerSaysSo) {
  writeExr(path("a.exr"), rgbImage(4, 4));
  for (const char* arguments : {"a.exr", "view a.exr", "view a.exr a.exr"}) {
    const Outcome run = laver(arguments, "env -u DISPLAY");
    EXPECT_EQ(run.code, 4) << arguments;
    EXPECT_EQ(lines(run.err), 1) << run.err;
    EXPECT_EQ(run.err.find("laver: no window: "), 0U) << run.err;
  }
}

TEST_F(CommandLine, TheViewerRefusesInvalidFiles) {
  writeExr(path("a.exr"), rgbImage(4, 4));
  writeExr(path("b.exr"), rgbImage(4, 5));
  for (const char* arguments : {"view", "view none.exr", "none.exr", "view a.exr b.exr"}) {
    const Outcome run = laver(arguments);
    EXPECT_EQ(run.code, 2) << arguments;
    EXPECT_EQ(lines(run.err), 1) << run.err;
  }
}

}  // namespace
}  // namespace laver::test
