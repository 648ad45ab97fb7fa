#pragma once
#include <cstdint>

#include "core/error.h"
#include "render/observer.h"

// What the operating system shares with the process: signals, standard streams, memory.
namespace laver {

/// While it lives, SIGINT and SIGTERM are noted instead of ending the process; the second of a kind
/// ends it at once. A signal that the process was started to ignore stays ignored. One at a time.
class Interruption : public Observer {
 public:
  Interruption();
  ~Interruption() override;
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool stop() override { return noted(); }

  /// Whether one of the two came.
  static bool noted();
  /// Does what Ctrl-C does, ignored or not.
  static void request();
  /// The exit code of what came first. Call it when one did.
  static ExitCode code();
};

/// Turns a closed pipe or a file beyond a limit into an error of the call that writes, and opens
/// the standard descriptors that the process was started without, so that no file it opens takes
/// their place; writing to them fails as before.
void prepareProcess();

/// Throws Error(Output) if anything that was printed to std::cout could not be written.
void flushStandardOutput();

/// The largest resident size of the process so far.
std::uint64_t peakBytes();

}  // namespace laver
