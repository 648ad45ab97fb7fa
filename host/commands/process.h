#pragma once
#include <cstdint>

#include "core/error.h"
#include "render/observer.h"

// The process: signals, standard streams, memory.
namespace laver {

/// During its lifetime, SIGINT and SIGTERM are recorded instead of ending the process; a second
/// signal of the same kind ends it at once. A signal that the parent had set to be ignored stays
/// ignored. Only one object may exist at a time.
class Interruption : public Observer {
 public:
  Interruption();
  ~Interruption() override;
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  bool stop() override { return noted(); }
  /// Ends the process if a signal came: nothing has been rendered that could be kept.
  void waiting() override;

  /// Whether one of the signals has arrived.
  static bool noted();
  /// Has the effect of Ctrl-C, even if SIGINT is ignored.
  static void request();
  /// The exit code for the first signal; only valid if noted().
  static ExitCode code();
};

/// Makes a lack of memory where nothing can be thrown, or before main(), end the process as
/// elsewhere: with a line and an exit code.
void reportLackOfMemory();

/// Makes writing to a closed pipe or beyond a file-size limit fail with an error instead of a
/// signal, makes a crash under `ulimit -v` an error of the device, and opens standard descriptors
/// that the process was started without, so that no other file gets their numbers; writing to them
/// fails as before.
void prepareProcess();

/// Throws Error(Output) if anything printed to std::cout could not be written.
void flushStandardOutput();

/// Peak resident size of the process, in bytes.
std::uint64_t peakBytes();

}  // namespace laver
