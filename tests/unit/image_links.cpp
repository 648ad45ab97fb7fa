// Links at the place of an output, and what killed processes leave.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "image/atomic_file.h"
#include "unit/image_test_folder.h"

namespace laver {
namespace {

namespace fs = std::filesystem;
using image_test::contents;
using image_test::expectError;
using image_test::Folder;

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

TEST(AtomicFileLink, StaysAndItsTargetIsReplaced) {
  const Folder folder;
  fs::create_directory(folder.file("sub"));
  std::ofstream(folder.file("sub/target")) << "old";
  fs::create_symlink("sub/middle", folder.file("link"));        // relative to the folder
  fs::create_symlink("target", folder.file("sub/middle"));      // relative to sub
  fs::create_symlink(folder.file("link"), folder.file("far"));  // absolute
  std::ifstream reader(folder.file("sub/target"));
  replaceFile(folder.file("far"), bytesOf("new"));
  EXPECT_EQ(contents(folder.file("sub/target")), "new");
  std::string before;
  reader >> before;
  EXPECT_EQ(before, "old");  // replaced, not overwritten
  EXPECT_EQ(fs::read_symlink(folder.file("link")), "sub/middle");
  EXPECT_EQ(fs::read_symlink(folder.file("sub/middle")), "target");
  EXPECT_TRUE(fs::is_symlink(folder.file("far")));
  EXPECT_EQ(folder.size(), 3u);
}

TEST(AtomicFileLink, MakesATargetThatIsNotThere) {
  const Folder folder;
  fs::create_symlink("target", folder.file("link"));
  checkReplaceable(folder.file("link"));
  EXPECT_EQ(folder.size(), 1u);
  replaceFile(folder.file("link"), bytesOf("new"));
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder.file("target"))));
  EXPECT_EQ(contents(folder.file("target")), "new");
}

TEST(AtomicFileLink, IsRefusedWhereItsTargetCannotBeReplaced) {
  const Folder folder;
  const auto refused = [&](const char* target, const char* reason) {
    fs::remove(folder.file("link"));
    fs::create_symlink(target, folder.file("link"));
    expectError(ExitCode::Output, reason, [&] { replaceFile(folder.file("link"), bytesOf("x")); });
  };
  refused("link", "link\": Too many levels of symbolic links");
  refused(".", "link\": Is a directory");
  refused("/dev/null", "link\": Is not a regular file");
  refused("away/file", "link\": No such file or directory");
}

/// A process that has begun to replace FOLDER/a and then waits for its end.
class Writer {
 public:
  explicit Writer(const std::string& file) {
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) return;
    process_ = fork();
    if (process_ == 0) {
      AtomicFile target(file);
      target.write(bytesOf("half"));
      if (write(ends[1], "x", 1) == 1) pause();
      _exit(1);
    }
    char c = 0;
    if (read(ends[0], &c, 1) != 1) ADD_FAILURE() << "the writer did not begin";
    close(ends[0]);
    close(ends[1]);
  }
  ~Writer() { kill(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
    process_ = -1;
  }

 private:
  pid_t process_ = -1;
};

TEST(AtomicFile, RemovesWhatKilledProcessesLeft) {
  const Folder folder;
  std::ofstream(folder.file("a")) << "old";
  // Not of laver's making, or not as laver makes them.
  std::ofstream(folder.file(".laver-1-2.tmp.bak")) << "keep";
  std::ofstream(folder.file(".laver-1.tmp")) << "keep";
  std::ofstream(folder.file(".laver-x-2.tmp")) << "keep";
  fs::create_directory(folder.file(".laver-1-2.tmp"));
  fs::create_symlink("a", folder.file(".laver-1-3.tmp"));
  const std::size_t others = 6;

  Writer writer(folder.file("a"));
  EXPECT_EQ(folder.size(), others + 1);
  const AtomicFile mine(folder.file("b"));
  EXPECT_EQ(folder.size(), others + 2);  // that of a process that lives stays
  writer.kill();
  EXPECT_EQ(folder.size(), others + 2);
  replaceFile(folder.file("a"), bytesOf("new"));
  EXPECT_EQ(folder.size(), others + 1);  // and so does one's own
  EXPECT_EQ(contents(folder.file("a")), "new");
}

TEST(AtomicFile, IsTheOldOrTheNewOneWheneverItsWriterIsKilled) {
  const Folder folder;
  const std::string file = folder.file("a");
  const std::size_t size = 1 << 20;
  replaceFile(file, bytesOf(std::string(size, 'a')));
  for (int moment = 0; moment < 60; ++moment) {
    const pid_t process = fork();
    ASSERT_GE(process, 0);
    if (process == 0) {
      const std::string texts[2] = {std::string(size, 'a'), std::string(size, 'b')};
      for (int i = 1;; ++i) replaceFile(file, bytesOf(texts[i % 2]));
    }
    usleep(1000 + 150 * static_cast<unsigned>(moment));
    kill(process, SIGKILL);
    waitpid(process, nullptr, 0);
    const std::string text = contents(file);
    ASSERT_EQ(text.size(), size) << moment;
    ASSERT_EQ(text.find_first_not_of(text[0]), std::string::npos) << moment;
  }
  checkReplaceable(file);
  EXPECT_EQ(folder.size(), 1u);
}

}  // namespace
}  // namespace laver
