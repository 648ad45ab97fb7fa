#pragma once
#include <stdexcept>
#include <string>

namespace laver {

/// Exit codes of the command line.
enum class ExitCode {
  Ok = 0,
  Output = 1,
  Usage = 2,
  Scene = 3,
  Device = 4,
  Different = 5,
  Interrupted = 130,  ///< 128 + SIGINT, as in shells
  Terminated = 143,   ///< 128 + SIGTERM
};

/// laver's only exception class. what() is ready to print: one line per error, without a final
/// newline.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace laver
