#pragma once
#include <chrono>
#include <functional>
#include <string>

#include "core/error.h"
#include "render/stats.h"
#include "show/viewed_pictures.h"

namespace laver {

/// Runs `render` on a thread of its own and shows in a window what it adds to the pictures, until
/// the window is closed, which ends a render as Ctrl-C does, or `render` throws. Without a window
/// there is a warning. Returns or throws what `render` does.
ExitCode runInWindow(const std::string& title,
                     const std::function<ExitCode(ViewedPictures&)>& render);

/// Tells a window how a render goes on.
class WindowReport {
 public:
  /// The picture is black at first. `samples` are those that a pixel is to get.
  WindowReport(ViewedPictures& pictures, const std::string& name, int width, int height,
               std::uint32_t samples);

  void rowsChanged(const Image& picture, int firstRow, int endRow) {
    pictures_.rowsChanged(picture, firstRow, endRow);
  }
  void progress(double share, const Stats& stats);
  void end(const Image& picture, const Stats& stats);

 private:
  using Clock = std::chrono::steady_clock;

  ViewedPictures& pictures_;
  double wanted_;  ///< samples
  const Clock::time_point start_ = Clock::now();
  ViewedPictures::Rendering first_, last_;  ///< from the first on the device is at work
  double firstSamples_ = 0.0;
};

}  // namespace laver
