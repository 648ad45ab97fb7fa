#include "core/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "image/io.h"
#include "support/expect_error.h"
#include "support/temporary_folder.h"

namespace laver::test {
namespace {

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

mode_t modeOf(const std::string& file) {
  struct stat status {};
  stat(file.c_str(), &status);
  return status.st_mode & 07777;
}

TEST(AtomicFile, CreatesAFileWithTheModeOfTheUmask) {
  const TemporaryFolder folder;
  const mode_t mask = umask(027);
  replaceFile(folder.path("a"), bytesOf("new"));
  umask(mask);
  EXPECT_EQ(contents(folder.path("a")), "new");
  EXPECT_EQ(modeOf(folder.path("a")), 0640u);
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(AtomicFile, ReplacesAFileAndKeepsItsMode) {
  const TemporaryFolder folder;
  std::ofstream(folder.path("a")) << "a longer old text";
  chmod(folder.path("a").c_str(), 0604);
  replaceFile(folder.path("a"), bytesOf("new"));
  EXPECT_EQ(contents(folder.path("a")), "new");
  EXPECT_EQ(modeOf(folder.path("a")), 0604u);
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(AtomicFile, KeepsTheOldFileUntilTheCommit) {
  const TemporaryFolder folder;
  std::ofstream(folder.path("a")) << "old";
  {
    AtomicFile file(folder.path("a"));
    file.write(bytesOf("new"));
    EXPECT_EQ(contents(folder.path("a")), "old");
    EXPECT_EQ(folder.names().size(), 2u);
  }
  EXPECT_EQ(contents(folder.path("a")), "old");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(AtomicFile, AReaderOfTheOldFileKeepsIt) {
  const TemporaryFolder folder;
  std::ofstream(folder.path("a")) << "old";
  std::ifstream reader(folder.path("a"));
  replaceFile(folder.path("a"), bytesOf("new"));
  std::string text;
  reader >> text;
  EXPECT_EQ(text, "old");
}

TEST(AtomicFile, ReplacesRegularFilesOnly) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name) { replaceFile(folder.path(name), bytesOf("new")); };
  std::filesystem::create_directory(folder.path("folder"));
  expectError(ExitCode::Output, "folder\": Is a directory", [&] { write("folder"); });

  ASSERT_EQ(mkfifo(folder.path("fifo").c_str(), 0600), 0);
  expectError(ExitCode::Output, "fifo\": Is not a regular file", [&] { write("fifo"); });
  expectError(ExitCode::Output, "no name", [&] { write("new/"); });
  expectError(ExitCode::Output, "no name", [&] { replaceFile("", bytesOf("x")); });
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST(AtomicFile, NeedsTheFolder) {
  const TemporaryFolder folder;
  expectError(ExitCode::Output, "away/a\": No such file or directory",
              [&] { replaceFile(folder.path("away/a"), bytesOf("new")); });
  std::ofstream(folder.path("a")) << "old";
  expectError(ExitCode::Output, "a/b\": Not a directory",
              [&] { replaceFile(folder.path("a/b"), bytesOf("new")); });
}

TEST(AtomicFile, FailsCleanlyWhenTheFolderIsRemovedMeanwhile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("sub"));
  AtomicFile file(folder.path("sub/a"));
  file.write(bytesOf("new"));
  std::filesystem::remove_all(folder.path("sub"));
  expectError(ExitCode::Output, "sub/a\": No such file", [&] { file.commit(); });
}

TEST(AtomicFile, FailsCleanlyWhenAFolderTakesThePlaceMeanwhile) {
  const TemporaryFolder folder;
  AtomicFile file(folder.path("a"));
  file.write(bytesOf("new"));
  std::filesystem::create_directory(folder.path("a"));
  expectError(ExitCode::Output, "a\": Is a directory", [&] { file.commit(); });
}

/// Root may write anywhere except where the kernel forbids it, so the test uses such a folder.
TEST(AtomicFile, NamesTheReasonIfTheFolderIsNotWritable) {
  expectError(ExitCode::Output,
              "/proc/picture.exr\": ", [] { writeExr("/proc/picture.exr", rgbImage(2, 2)); });
}

/// A limit on file sizes simulates a full disk: write() fails half-way in both cases.
class LimitedFileSize {
 public:
  explicit LimitedFileSize(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &old_);
    const rlimit limit{bytes, old_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~LimitedFileSize() {
    setrlimit(RLIMIT_FSIZE, &old_);
    std::signal(SIGXFSZ, handler_);
  }
  LimitedFileSize(const LimitedFileSize&) = delete;
  LimitedFileSize& operator=(const LimitedFileSize&) = delete;

 private:
  void (*handler_)(int);
  rlimit old_{};
};

TEST(AtomicFile, KeepsTheOldPictureWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const Image old = rgbImage(8, 8);
  writeExr(folder.path("a.exr"), old);
  replaceFile(folder.path("a.png"), encodePng(old));
  const std::string exr = contents(folder.path("a.exr"));
  const std::string png = contents(folder.path("a.png"));
  {
    const LimitedFileSize limit(50);
    Image image = rgbImage(8, 8);
    image.pixels[0] = 1.0f;
    expectError(ExitCode::Output, "File too large", [&] { writeExr(folder.path("a.exr"), image); });
    expectError(ExitCode::Output, "File too large",
                [&] { replaceFile(folder.path("a.png"), encodePng(image)); });
  }
  EXPECT_EQ(contents(folder.path("a.exr")), exr);
  EXPECT_EQ(contents(folder.path("a.png")), png);
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST(CheckReplaceable, FailsEarlyAndLeavesNothing) {
  const TemporaryFolder folder;
  checkReplaceable(folder.path("a"));
  EXPECT_EQ(folder.names().size(), 0u);
  std::ofstream(folder.path("a")) << "old";
  checkReplaceable(folder.path("a"));
  EXPECT_EQ(contents(folder.path("a")), "old");
  expectError(ExitCode::Output, "No such file", [&] { checkReplaceable(folder.path("away/a")); });
}

}  // namespace
}  // namespace laver::test
