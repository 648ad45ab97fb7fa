#pragma once
#include <chrono>
#include <functional>
#include <string>

#include "core/error.h"
#include "render/observer.h"
#include "show/viewed_pictures.h"

namespace laver {

/// A line on stderr with the finished share, elapsed and remaining time; only on a terminal, and at
/// most ten times per second. The destructor erases the line.
class Progress : public Observer {
 public:
  explicit Progress(bool wanted);
  ~Progress() override;
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void progress(double share, std::uint64_t samples) override;
  void finished(const Image& /*picture*/) override { wipe(); }
  /// Erases the line, before something else is printed.
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;
  bool active_;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

/// Shows a render in a window.
class WindowReport : public Observer {
 public:
  /// Adds a black picture to `pictures`.
  WindowReport(ViewedPictures& pictures, const std::string& name, int width, int height);

  void started(const std::string& device) override { last_.device = device; }
  void progress(double share, std::uint64_t samples) override;
  void rowsChanged(const Image& picture, int first, int end) override {
    pictures_.rowsChanged(picture, first, end);
  }
  void finished(const Image& picture) override;
  double timeShare() const override { return 0.01; }

 private:
  using Clock = std::chrono::steady_clock;

  ViewedPictures& pictures_;
  const Clock::time_point start_ = Clock::now();
  ViewedPictures::Rendering first_, last_;  ///< first_: the first report after the start
  std::uint64_t firstSamples_ = 0;
};

/// Runs `render` on another thread, and shows the pictures that it adds in a window, until the
/// window is closed, which stops the render as Ctrl-C does, or `render` throws. If no window can be
/// opened, warns and renders without one. Returns or throws what `render` does.
ExitCode runInWindow(const std::string& title,
                     const std::function<ExitCode(ViewedPictures&)>& render);

}  // namespace laver
