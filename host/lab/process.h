#pragma once
#include <string>
#include <vector>

namespace laver {

/// How a child process ended.
struct ProcessRun {
  int exitCode = 0;         ///< 128 + the signal's number where a signal ended it
  double seconds = 0;       ///< from its start to its end
  std::string errorOutput;  ///< all of stderr
};

/// Runs a program, found by the PATH, with stdout discarded, and waits for its end. Throws
/// Error(Usage) where it cannot be started.
ProcessRun runProcess(std::vector<std::string> arguments);

}  // namespace laver
