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
  Interrupted = 130,  ///< 128 + SIGINT, as shells have it
  Terminated = 143,   ///< 128 + SIGTERM
};

/// The one exception of laver. what() is ready to print: one line an error, without a final
/// newline.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace laver
