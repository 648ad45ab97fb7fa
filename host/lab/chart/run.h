#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver::chart {

/// Exit code of a peer that cannot run here (EX_UNAVAILABLE of sysexits.h).
inline constexpr int kUnavailable = 69;
/// The same of `env` and shells: there is no such program.
inline constexpr int kNotFound = 127;

/// One render by a process of its own.
// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON asserts, and throws nothing
struct Run {
  int exitCode = 0;
  double seconds = 0;     ///< of the whole process
  nlohmann::json stats;   ///< what its --stats=FILE.json holds; null where it failed
  std::string lastError;  ///< the last line of stderr
};

/// Renders by programs that take laver's options. Their files lie in a folder and are removed.
class Runner {
 public:
  explicit Runner(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// `command... -o FILE.exr --stats=FILE.json --quiet`. Throws Error(Usage) where it cannot be
  /// started.
  Run run(std::vector<std::string> command) const;

  /// R, G and B of the latest run's picture. Throws Error.
  Image picture() const;

 private:
  std::string file(const char* extension) const {
    return (folder_ / "running").string() + extension;
  }
  std::filesystem::path folder_;
};

}  // namespace laver::chart
