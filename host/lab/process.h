#pragma once
#include <functional>
#include <string>
#include <vector>

namespace laver {

/// Result of a child process.
struct ProcessRun {
  int exitCode = 0;         ///< 128 + the signal's number if a signal ended it
  double seconds = 0;       ///< from its start to its end
  std::string errorOutput;  ///< all of stderr
};

/// Runs a program, found by PATH, with stdout in the file `output`, and waits until it ends; sends
/// it SIGTERM once `stopped` holds. Throws Error(Usage) if it cannot be started.
ProcessRun runProcess(
    std::vector<std::string> arguments, const std::string& output = "/dev/null",
    const std::function<bool()>& stopped = [] { return false; });

}  // namespace laver
