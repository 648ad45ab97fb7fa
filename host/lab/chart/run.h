#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver::chart {

/// Exit code of a peer that is not available (EX_UNAVAILABLE of sysexits.h).
inline constexpr int kUnavailable = 69;
/// Exit code of `env` and shells if the program does not exist.
inline constexpr int kNotFound = 127;

/// The result of one render in its own process.
// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON asserts, and throws nothing
struct Run {
  int exitCode = 0;
  double seconds = 0;     ///< of the whole process
  nlohmann::json stats;   ///< content of its --stats=FILE.json; null if it failed
  std::string lastError;  ///< the last line of stderr
};

/// Runs programs that take laver's options. Their output files lie in a folder and are removed at
/// the end.
class Runner {
 public:
  explicit Runner(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// Runs `command... -o FILE.exr --stats=FILE.json --quiet`. Throws Error(Usage) if it cannot be
  /// started.
  Run run(std::vector<std::string> command) const;

  /// R, G and B of the latest run's picture. Throws Error.
  Image picture() const;
  Image allChannels() const;

 private:
  std::string file(const char* extension) const {
    return (folder_ / "running").string() + extension;
  }
  std::filesystem::path folder_;
};

}  // namespace laver::chart
