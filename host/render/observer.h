#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/throttle.h"
#include "image/image.h"

namespace laver {

/// Follows a render: a window, a viewer, a progress line, an interruption. All calls come from the
/// thread that renders.
class Observer {
 public:
  virtual ~Observer() = default;

  /// `device` begins to render.
  virtual void started(const std::string& /*device*/) {}
  /// Called before each pass; true ends the render there.
  virtual bool stop() { return false; }
  /// Called now and then with the share of the render that is done, 0 to 1, and the number of
  /// samples traced so far.
  virtual void progress(double /*share*/, std::uint64_t /*samples*/) {}
  /// Rows [first, end) of the scene's own picture, which is valid during the call, have new values.
  /// The last call for a row brings its final values.
  virtual void rowsChanged(const Image& /*picture*/, int /*first*/, int /*end*/) {}
  /// The render has ended with this picture, which has all layers.
  virtual void finished(const Image& /*picture*/) {}
  /// Share of the render's time that showing rows before they are final may take; 0: none of it.
  virtual double timeShare() const { return 0.0; }
};

/// Whether one of the observers ends the render.
bool stops(const std::vector<Observer*>& observers);

/// Tells all observers of a render what happens, within the largest of their time shares.
class Observers {
 public:
  explicit Observers(const std::vector<Observer*>& observers);

  void started(const std::string& device) const;
  bool stop() const { return stops(observers_); }
  /// What follows is about picture `index` of `count`; rows are shown of picture 0 alone.
  void beginPicture(std::size_t index, std::size_t count);
  /// `share` of the present picture is done.
  void progress(double share, std::uint64_t samples) const;
  void rowsChanged(const Image& picture, int first, int end) const;
  void finished(const Image& picture) const;

  /// Whether rows that are not final may be shown now.
  bool due() const { return index_ == 0 && throttle_.due(); }
  /// Runs resolve(), which makes rows and shows them: its time counts against the time share.
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
