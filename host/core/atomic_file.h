#pragma once
#include <cstddef>
#include <span>
#include <string>

namespace laver {

/// A file that appears whole or not at all: it is written under another name in the same folder,
/// flushed to the disk and renamed. Until commit() the old file is untouched; without commit()
/// nothing remains. A symbolic link is followed: the link stays, and its target is created or
/// replaced. Only a regular file is ever replaced, never a folder or a device. Temporary files that
/// killed processes left in the folder are removed. Every function throws Error(Output) with one
/// line: the path and the reason.
class AtomicFile {
 public:
  /// Opens the temporary file; fails if `file` could not be replaced later.
  explicit AtomicFile(std::string file);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::span<const std::byte> bytes);
  /// Puts the file in its place. Call it once, as the last function.
  void commit();

 private:
  [[noreturn]] void fail(int error) const;

  std::string file_;       ///< as given, for messages
  std::string target_;     ///< with links resolved
  std::string temporary_;  ///< empty once renamed
  int descriptor_ = -1;
};

/// Atomically replaces `file` by `bytes`. Throws Error(Output).
void replaceFile(const std::string& file, std::span<const std::byte> bytes);

/// Throws the Error(Output) that replacing `file` would cause later: a missing folder, no
/// permission, a folder of that name. Leaves nothing behind.
void checkReplaceable(const std::string& file);

}  // namespace laver
