#include "image/temporary_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <string_view>

namespace laver {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

int openTemporary(const std::string& folder, std::string& name) {
  static std::atomic<unsigned> counter{0};
  for (;;) {
    name = fmt::format("{}.laver-{}-{}.tmp", folder, getpid(), counter++);
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) return -1;
    // Where there are no locks nobody can take the file for abandoned. Otherwise somebody may have
    // done so before it was locked.
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (locked && access(name.c_str(), F_OK) == 0) return descriptor;
    close(descriptor);
  }
}

void removeAbandoned(const std::string& folder) {
  std::error_code error;
  fs::directory_iterator entry(folder.empty() ? "." : folder, error);
  while (!error && entry != fs::directory_iterator()) {
    if (isTemporaryName(entry->path().filename().native()))
      removeIfAbandoned(entry->path().c_str());
    entry.increment(error);
  }
}

}  // namespace laver
