#pragma once
#include <filesystem>
#include <optional>

#include "kernels/compile.h"

namespace laver {

/// 128 bits of a kernel's text and of the compiler's version, in hexadecimal.
std::string hashOfKernel(const std::string& text);

/// Compiled kernels in files, one per hash. It may be lost at any time: files that are damaged, cut
/// short or unreadable count as absent, and nothing that goes wrong is an error. Processes may
/// share it: a file appears whole or not at all.
class KernelCache {
 public:
  /// In `folder`; an empty path keeps nothing.
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
