#pragma once
#include <filesystem>
#include <optional>

#include "kernels/compile.h"

namespace laver {

/// 128-bit hash of a kernel's text and the compiler's version, in hexadecimal.
std::string hashOfKernel(const std::string& text);

/// Compiled kernels in files, one per hash. The files may be deleted at any time: damaged,
/// truncated or unreadable files count as absent, and no failure is an error. Processes may share
/// the folder, since a file appears whole or not at all.
class KernelCache {
 public:
  /// `folder` may be empty: then nothing is cached.
  explicit KernelCache(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// $XDG_CACHE_HOME/laver/kernels or ~/.cache/laver/kernels.
  static KernelCache ofUser();

  std::optional<Spirv> read(const std::string& hash) const;
  /// Also removes the oldest files beyond kFiles.
  void write(const std::string& hash, const Spirv& module) const;

  static constexpr std::size_t kFiles = 256;

 private:
  std::filesystem::path fileOf(const std::string& hash) const { return folder_ / (hash + ".spv"); }
  void prune() const;

  std::filesystem::path folder_;
};

}  // namespace laver
