#include "core/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.h"

namespace laver {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& file, const std::string& reason) {
  throw Error(ExitCode::Output, fmt::format("cannot write \"{}\": {}", file, reason));
}

std::string folderOf(const std::string& file) {
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "./" : file.substr(0, slash + 1);
}

/// The path that `file` resolves to through symbolic links; it need not exist.
std::string followLinks(const std::string& file) {
  constexpr int kMaxLinks = 40;  // as in Linux
  std::error_code error;
  fs::path path = file;
  for (int links = 0; fs::is_symlink(fs::symlink_status(path, error)); ++links) {
    if (links == kMaxLinks) refuse(file, std::generic_category().message(ELOOP));
    const fs::path next = fs::read_symlink(path, error);
    if (error) refuse(file, error.message());
    path = path.parent_path() / next;  // is `next` if that is absolute
  }
  return path.string();
}

/// Permissions of the file to be replaced, 0 if there is none.
mode_t replaceableMode(const std::string& file, const std::string& target) {
  struct stat status {};
  if (lstat(target.c_str(), &status) != 0) return 0;
  if (S_ISDIR(status.st_mode)) refuse(file, std::generic_category().message(EISDIR));
  if (!S_ISREG(status.st_mode)) refuse(file, "Is not a regular file");
  if (access(target.c_str(), W_OK) != 0) refuse(file, std::generic_category().message(errno));
  return status.st_mode & 07777;
}

constexpr std::string_view kPrefix = ".laver-", kSuffix = ".tmp";

bool isTemporaryName(std::string_view name) {
  if (name.size() <= kPrefix.size() + kSuffix.size() || !name.starts_with(kPrefix) ||
      !name.ends_with(kSuffix))
    return false;
  name = name.substr(kPrefix.size(), name.size() - kPrefix.size() - kSuffix.size());
  return std::count(name.begin(), name.end(), '-') == 1 && name.front() != '-' &&
         name.back() != '-' && name.find_first_not_of("0123456789-") == std::string_view::npos;
}

void removeIfAbandoned(const char* file) {
  const int descriptor = open(file, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return;
  struct stat status {};
  if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
      flock(descriptor, LOCK_EX | LOCK_NB) == 0)
    unlink(file);
  close(descriptor);
}

/// Creates a file in `folder` (empty: the working folder), open for writing and locked as long as
/// it is open, and sets `name` to its path. Returns its descriptor, or -1 with errno set.
int openTemporary(const std::string& folder, std::string& name) {
  static std::atomic<unsigned> counter{0};
  for (;;) {
    name = fmt::format("{}.laver-{}-{}.tmp", folder, getpid(), counter++);
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) return -1;
    // A file system without locks never reports the file as abandoned. With locks, another process
    // may have removed it before it was locked.
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (locked && access(name.c_str(), F_OK) == 0) return descriptor;
    close(descriptor);
  }
}

/// Removes from `folder` the temporary files that no process has open any more because their
/// process was killed. The lock shows that, not the process number in the name, which means nothing
/// to another machine or container that shares the folder. Files that cannot be locked stay.
void removeAbandoned(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator entry(folder.empty() ? "." : folder, error);
  while (!error && entry != fs::directory_iterator()) {
    if (isTemporaryName(entry->path().filename().native()))
      removeIfAbandoned(entry->path().c_str());
    entry.increment(error);
  }
}

}  // namespace

AtomicFile::AtomicFile(std::string file) : file_(std::move(file)), target_(followLinks(file_)) {
  const mode_t mode = replaceableMode(file_, target_);
  if (target_.empty() || target_.back() == '/') refuse(file_, "The file has no name");
  const std::string folder = folderOf(target_);
  removeAbandoned(folder);
  descriptor_ = openTemporary(folder, temporary_);
  if (descriptor_ < 0) fail(errno);
  if (mode != 0) static_cast<void>(fchmod(descriptor_, mode));  // some file systems have no modes
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  // EINVAL: the file system cannot flush; the rename is atomic nevertheless.
  if (fsync(descriptor_) != 0 && errno != EINVAL) fail(errno);
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  const int folder = open(folderOf(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;  // the folder may be writable but not readable
  fsync(folder);
  close(folder);
}

void AtomicFile::fail(int error) const { refuse(file_, std::generic_category().message(error)); }

void replaceFile(const std::string& file, std::span<const std::byte> bytes) {
  AtomicFile target(file);
  target.write(bytes);
  target.commit();
}

void checkReplaceable(const std::string& file) { const AtomicFile probe(file); }

}  // namespace laver
