// Outputs that are symbolic links, and leftovers of killed processes.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/atomic_file.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

namespace fs = std::filesystem;

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

TEST(AtomicFileLink, StaysAndItsTargetIsReplaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path("sub"));
  std::ofstream(folder.path("sub/target")) << "old";
  fs::create_symlink("sub/middle", folder.path("link"));        // relative to the folder
  fs::create_symlink("target", folder.path("sub/middle"));      // relative to sub
  fs::create_symlink(folder.path("link"), folder.path("far"));  // absolute
  std::ifstream reader(folder.path("sub/target"));
  replaceFile(folder.path("far"), bytesOf("new"));
  EXPECT_EQ(contents(folder.path("sub/target")), "new");
  std::string before;
  reader >> before;
  EXPECT_EQ(before, "old");  // replaced, not overwritten
  EXPECT_EQ(fs::read_symlink(folder.path("link")), "sub/middle");
  EXPECT_EQ(fs::read_symlink(folder.path("sub/middle")), "target");
  EXPECT_TRUE(fs::is_symlink(folder.path("far")));
  EXPECT_EQ(folder.names().size(), 3u);
}

TEST(AtomicFileLink, CreatesAMissingTarget) {
  const TemporaryFolder folder;
  fs::create_symlink("target", folder.path("link"));
  checkReplaceable(folder.path("link"));
  EXPECT_EQ(folder.names().size(), 1u);
  replaceFile(folder.path("link"), bytesOf("new"));
  EXPECT_TRUE(fs::is_symlink(folder.path("link")));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder.path("target"))));
  EXPECT_EQ(contents(folder.path("target")), "new");
}

TEST(AtomicFileLink, IsRefusedIfItsTargetCannotBeReplaced) {
  const TemporaryFolder folder;
  const auto refused = [&](const char* target, const char* reason) {
    fs::remove(folder.path("link"));
    fs::create_symlink(target, folder.path("link"));
    expectError(ExitCode::Output, reason, [&] { replaceFile(folder.path("link"), bytesOf("x")); });
  };
  refused("link", "link\": Too many levels of symbolic links");
  refused(".", "link\": Is a directory");
  refused("/dev/null", "link\": Is not a regular file");
  refused("away/file", "link\": No such file or directory");
}

/// A process that has started to replace FOLDER/a and then waits until it is killed.
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
    close(ends[1]);  // the read ends with the writer
    char c = 0;
    if (read(ends[0], &c, 1) != 1) ADD_FAILURE() << "the writer did not begin";
    close(ends[0]);
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
  const TemporaryFolder folder;
  std::ofstream(folder.path("a")) << "old";
  // Files that laver has not created, or whose names have another form.
  std::ofstream(folder.path(".laver-1-2.tmp.bak")) << "keep";
  std::ofstream(folder.path(".laver-1.tmp")) << "keep";
  std::ofstream(folder.path(".laver-x-2.tmp")) << "keep";
  fs::create_directory(folder.path(".laver-1-2.tmp"));
  fs::create_symlink("a", folder.path(".laver-1-3.tmp"));
  const std::size_t others = 6;

  Writer writer(folder.path("a"));
  EXPECT_EQ(folder.names().size(), others + 1);
  const AtomicFile mine(folder.path("b"));
  EXPECT_EQ(folder.names().size(), others + 2);  // the file of a running process stays
  writer.kill();
  EXPECT_EQ(folder.names().size(), others + 2);
  replaceFile(folder.path("a"), bytesOf("new"));
  EXPECT_EQ(folder.names().size(), others + 1);  // and so does this process' own
  EXPECT_EQ(contents(folder.path("a")), "new");
}

TEST(AtomicFile, IsTheOldOrTheNewOneWhenItsWriterIsKilled) {
  const TemporaryFolder folder;
  const std::string file = folder.path("a");
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
  EXPECT_EQ(folder.names().size(), 1u);
}

}  // namespace
}  // namespace laver::test
