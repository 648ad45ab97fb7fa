#pragma once
#include <chrono>

namespace laver {

/// Limits how often an action runs, so that it takes at most a share of the time.
class Throttle {
 public:
  /// With a share of 0 the action is never due. Before the first run it waits as long as after a
  /// run of 2 ms.
  explicit Throttle(double share) : share_(share), next_(after(Clock::now(), Seconds(2e-3))) {}

  bool due() const { return Clock::now() >= next_; }

  template <class Action>
  void run(const Action& action) {
    const Clock::time_point start = Clock::now();
    action();
    const Clock::time_point end = Clock::now();
    next_ = after(end, end - start);
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  Clock::time_point after(Clock::time_point end, Seconds taken) const {
    if (share_ == 0.0) return Clock::time_point::max();
    return end + std::chrono::duration_cast<Clock::duration>(taken / share_);
  }

  double share_;
  Clock::time_point next_;
};

}  // namespace laver
