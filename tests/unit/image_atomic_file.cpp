#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "image/atomic_file.h"
#include "image/io.h"
#include "unit/image_test_folder.h"

namespace laver {
namespace {

using image_test::contents;
using image_test::expectError;
using image_test::Folder;

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

mode_t modeOf(const std::string& file) {
  struct stat status {};
  stat(file.c_str(), &status);
  return status.st_mode & 07777;
}

TEST(AtomicFile, MakesANewFileAsTheUmaskSays) {
  const Folder folder;
  const mode_t mask = umask(027);
  replaceFile(folder.file("a"), bytesOf("new"));
  umask(mask);
  EXPECT_EQ(contents(folder.file("a")), "new");
  EXPECT_EQ(modeOf(folder.file("a")), 0640u);
  EXPECT_EQ(folder.size(), 1u);
}

TEST(AtomicFile, ReplacesAFileAndKeepsItsMode) {
  const Folder folder;
  std::ofstream(folder.file("a")) << "a longer old text";
  chmod(folder.file("a").c_str(), 0604);
  replaceFile(folder.file("a"), bytesOf("new"));
  EXPECT_EQ(contents(folder.file("a")), "new");
  EXPECT_EQ(modeOf(folder.file("a")), 0604u);
  EXPECT_EQ(folder.size(), 1u);
}

TEST(AtomicFile, KeepsTheOldFileUntilTheCommit) {
  const Folder folder;
  std::ofstream(folder.file("a")) << "old";
  {
    AtomicFile file(folder.file("a"));
    file.write(bytesOf("new"));
    EXPECT_EQ(contents(folder.file("a")), "old");
    EXPECT_EQ(folder.size(), 2u);
  }
  EXPECT_EQ(contents(folder.file("a")), "old");
  EXPECT_EQ(folder.size(), 1u);
}

TEST(AtomicFile, AReaderOfTheOldFileKeepsIt) {
  const Folder folder;
  std::ofstream(folder.file("a")) << "old";
  std::ifstream reader(folder.file("a"));
  replaceFile(folder.file("a"), bytesOf("new"));
  std::string text;
  reader >> text;
  EXPECT_EQ(text, "old");
}

TEST(AtomicFile, RefusesWhatIsNoRegularFile) {
  const Folder folder;
  const auto write = [&](const char* name) { replaceFile(folder.file(name), bytesOf("new")); };
  std::filesystem::create_directory(folder.file("folder"));
  expectError(ExitCode::Output, "folder\": Is a directory", [&] { write("folder"); });

  ASSERT_EQ(mkfifo(folder.file("fifo").c_str(), 0600), 0);
  expectError(ExitCode::Output, "fifo\": Is not a regular file", [&] { write("fifo"); });
  expectError(ExitCode::Output, "no name", [&] { write("new/"); });
  expectError(ExitCode::Output, "no name", [&] { replaceFile("", bytesOf("x")); });
  EXPECT_EQ(folder.size(), 2u);
}

TEST(AtomicFile, NeedsTheFolder) {
  const Folder folder;
  expectError(ExitCode::Output, "away/a\": No such file or directory",
              [&] { replaceFile(folder.file("away/a"), bytesOf("new")); });
  std::ofstream(folder.file("a")) << "old";
  expectError(ExitCode::Output, "a/b\": Not a directory",
              [&] { replaceFile(folder.file("a/b"), bytesOf("new")); });
}

TEST(AtomicFile, FailsCleanlyWhenTheFolderGoesAwayMeanwhile) {
  const Folder folder;
  std::filesystem::create_directory(folder.file("sub"));
  AtomicFile file(folder.file("sub/a"));
  file.write(bytesOf("new"));
  std::filesystem::remove_all(folder.file("sub"));
  expectError(ExitCode::Output, "sub/a\": No such file", [&] { file.commit(); });
}

TEST(AtomicFile, KeepsTheOldFileWhenAFolderTakesItsPlaceMeanwhile) {
  const Folder folder;
  AtomicFile file(folder.file("a"));
  file.write(bytesOf("new"));
  std::filesystem::create_directory(folder.file("a"));
  expectError(ExitCode::Output, "a\": Is a directory", [&] { file.commit(); });
}

/// Root may write anywhere but where the kernel forbids it to all.
TEST(AtomicFile, NamesTheReasonOfAFolderThatTakesNoFiles) {
  expectError(ExitCode::Output,
              "/proc/picture.exr\": ", [] { writeExr("/proc/picture.exr", rgbImage(2, 2)); });
}

/// A limit on file sizes stands in for a full disk: write() fails half-way in both.
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
  const Folder folder;
  const Image old = rgbImage(8, 8);
  writeExr(folder.file("a.exr"), old);
  writePng(folder.file("a.png"), old);
  const std::string exr = contents(folder.file("a.exr"));
  const std::string png = contents(folder.file("a.png"));
  {
    const LimitedFileSize limit(50);
    Image image = rgbImage(8, 8);
    image.pixels[0] = 1.0f;
    expectError(ExitCode::Output, "File too large", [&] { writeExr(folder.file("a.exr"), image); });
    expectError(ExitCode::Output, "File too large", [&] { writePng(folder.file("a.png"), image); });
  }
  EXPECT_EQ(contents(folder.file("a.exr")), exr);
  EXPECT_EQ(contents(folder.file("a.png")), png);
  EXPECT_EQ(folder.size(), 2u);
}

TEST(CheckReplaceable, SaysEarlyWhatWouldFailLateAndLeavesNothing) {
  const Folder folder;
  checkReplaceable(folder.file("a"));
  EXPECT_EQ(folder.size(), 0u);
  std::ofstream(folder.file("a")) << "old";
  checkReplaceable(folder.file("a"));
  EXPECT_EQ(contents(folder.file("a")), "old");
  expectError(ExitCode::Output, "No such file", [&] { checkReplaceable(folder.file("away/a")); });
}

}  // namespace
}  // namespace laver
