#pragma once
#include <chrono>

#include "render/observer.h"

namespace laver {

/// A line on stderr with the share done, elapsed and remaining time; only on a terminal, and at
/// most ten times a second. Its end wipes the line.
class Progress : public Observer {
 public:
  explicit Progress(bool wanted);
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void progress(double share, std::uint64_t samples) override;
  void show(double share);
  /// Makes room for a line of something else.
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;
  bool active_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace laver
