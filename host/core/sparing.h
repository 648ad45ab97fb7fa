#pragma once
#include <chrono>

namespace laver {

/// Does something so seldom that it takes no more than a share of the time.
class Sparing {
 public:
  /// It first waits as if it had just taken 2 ms.
  explicit Sparing(double share) : share_(share), next_(Clock::now() + pauseFor(Seconds(2e-3))) {}

  bool due() const { return Clock::now() >= next_; }

  template <class Action>
  void run(const Action& action) {
    const Clock::time_point start = Clock::now();
    action();
    const Clock::time_point end = Clock::now();
    next_ = end + pauseFor(end - start);
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;

  Clock::duration pauseFor(Seconds taken) const {
    return std::chrono::duration_cast<Clock::duration>(taken / share_);
  }

  double share_;
  Clock::time_point next_;
};

}  // namespace laver
