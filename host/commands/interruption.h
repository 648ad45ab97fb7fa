#pragma once
#include "core/error.h"
#include "render/observer.h"

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

}  // namespace laver
