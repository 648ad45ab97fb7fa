#pragma once
#include <chrono>

namespace laver {

/// A line on stderr with the share done, elapsed and remaining time; only on a terminal, and at
/// most ten times a second. Its end wipes the line.
class Progress {
 public:
  explicit Progress(bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

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
