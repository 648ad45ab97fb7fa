#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace laver {

/// A file that appears whole or not at all: written under another name in the same folder, flushed
/// to the disk and renamed. Until commit() the old file is untouched; without it nothing stays.
/// A symbolic link is followed: it stays, and what it names is made or replaced. What is in the way
/// and is no regular file (a folder, a device) is never replaced. What killed processes left of
/// other such files in the folder is removed.
/// Every function throws Error(Output) with one line: the path and the reason.
class AtomicFile {
 public:
  /// Opens the temporary file, so it fails where `file` could not be replaced later.
  explicit AtomicFile(std::string file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::span<const std::byte> bytes);
  /// Puts the file in its place; call it once, last.
  void commit();

 private:
  [[noreturn]] void fail(int error) const;

  std::string file_;       ///< as given, for messages
  std::string target_;     ///< without links
  std::string temporary_;  ///< empty once renamed
  int descriptor_ = -1;
};

/// Makes `file` hold exactly `bytes`, as AtomicFile does. Throws Error(Output).
void replaceFile(const std::string& file, std::span<const std::byte> bytes);

/// Throws now the Error(Output) that replacing `file` would meet later: a missing folder, no
/// permission, something in the way. Leaves nothing behind.
void checkReplaceable(const std::string& file);

}  // namespace laver
