#pragma once
#include <chrono>
#include <functional>
#include <string>

#include "core/error.h"
#include "render/observer.h"
#include "show/viewed_pictures.h"

namespace laver {

/// Runs `render` on a thread of its own and shows in a window what it adds to the pictures, until
/// the window is closed, which ends a render as Ctrl-C does, or `render` throws. Without a window
/// there is a warning. Returns or throws what `render` does.
ExitCode runInWindow(const std::string& title,
                     const std::function<ExitCode(ViewedPictures&)>& render);

/// Shows a render in a window.
class WindowReport : public Observer {
 public:
  /// The picture is black at first.
  WindowReport(ViewedPictures& pictures, const std::string& name, int width, int height);

  void started(const std::string& device) override { last_.device = device; }
  void progress(double share, std::uint64_t samples) override;
  void rowsChanged(const Image& picture, int first, int end) override {
    pictures_.rowsChanged(picture, first, end);
  }
  double timeShare() const override { return 0.01; }
  /// The render is over.
  void end(const Image& picture);

 private:
  using Clock = std::chrono::steady_clock;

  ViewedPictures& pictures_;
  const Clock::time_point start_ = Clock::now();
  ViewedPictures::Rendering first_, last_;  ///< from the first on the device is at work
  std::uint64_t firstSamples_ = 0;
};

}  // namespace laver
