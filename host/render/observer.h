#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/throttle.h"
#include "image/image.h"

namespace laver {

/// Observes a render: a window, a viewer, a progress line, an interruption. All calls come from the
/// rendering thread.
class Observer {
 public:
  virtual ~Observer() = default;

  /// Rendering starts on `device`.
  virtual void started(const std::string& /*device*/) {}
  /// Called before each pass; returning true stops the render.
  virtual bool stop() { return false; }
  /// Called from time to time while the driver compiles kernels, which cannot be interrupted. It
  /// may end the process.
  virtual void waiting() {}
  /// Called from time to time with the finished share of the render, 0 to 1, and the number of
  /// samples traced so far.
  virtual void progress(double /*share*/, std::uint64_t /*samples*/) {}
  /// Rows [first, end) of the main picture have new values; the picture is valid during the call.
  /// The last call for a row has its final values.
  virtual void rowsChanged(const Image& /*picture*/, int /*first*/, int /*end*/) {}
  /// The render has ended with this picture, including all layers.
  virtual void finished(const Image& /*picture*/) {}
  /// Share of the render's time that may be spent on showing unfinished rows; 0: none.
  virtual double timeShare() const { return 0.0; }
};

/// Whether one of the observers stops the render.
bool stops(const std::vector<Observer*>& observers);

/// Passes a render's events to all observers, within the largest of their time shares.
class Observers {
 public:
  explicit Observers(const std::vector<Observer*>& observers);

  void started(const std::string& device) const;
  bool stop() const { return stops(observers_); }
  void waiting() const;
  /// The following events concern picture `index` of `count`; only rows of picture 0 are reported.
  void beginPicture(std::size_t index, std::size_t count);
  /// `share` of the current picture is finished.
  void progress(double share, std::uint64_t samples) const;
  void rowsChanged(const Image& picture, int first, int end) const;
  void finished(const Image& picture) const;

  /// Whether unfinished rows may be shown now.
  bool due() const { return index_ == 0 && throttle_.due(); }
  /// Runs resolve(), which resolves and reports rows; its duration counts towards the time share.
  template <class Resolve>
  void show(const Resolve& resolve) {
    throttle_.run(resolve);
  }

 private:
  std::vector<Observer*> observers_;
  std::size_t index_ = 0, count_ = 1;
  Throttle throttle_;
};

}  // namespace laver
