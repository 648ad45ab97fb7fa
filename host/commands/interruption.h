#pragma once
#include "core/error.h"

namespace laver {

/// While it lives, SIGINT and SIGTERM are noted instead of ending the process; the second of a kind
/// ends it at once. A signal that the process was started to ignore stays ignored. One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// Whether one of the two came.
  static bool noted();
  /// Does what Ctrl-C does, ignored or not.
  static void request();
  /// The exit code of what came first. Call it when one did.
  static ExitCode code();
};

}  // namespace laver
