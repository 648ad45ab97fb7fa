#include "commands/in_window.h"

#include <atomic>
#include <future>
#include <iostream>

#include "commands/interruption.h"
#include "show/window.h"

namespace laver {

ExitCode runInWindow(const std::string& title,
                     const std::function<ExitCode(ViewedPictures&)>& render) {
  ViewedPictures pictures;
  std::atomic<bool> failed = false;
  auto ended = std::async(std::launch::async, [&] {
    try {
      return render(pictures);
    } catch (...) {
      failed = true;
      throw;
    }
  });
  const auto isOver = [&](std::chrono::milliseconds wait) {
    return ended.wait_for(wait) == std::future_status::ready;
  };
  const auto nothing = [](const auto& contents) { return contents.images.empty(); };
  while (pictures.read(nothing) && !isOver(std::chrono::milliseconds(2))) {
  }
  if (failed) return ended.get();
  try {
    runWindow(title, pictures, [&] { return failed.load(); });
    if (!isOver(std::chrono::milliseconds(0))) Interruption::request();
  } catch (const std::exception& error) {
    std::cerr << "laver: warning: " << error.what() << '\n';
  }
  return ended.get();
}

WindowReport::WindowReport(ViewedPictures& pictures, const std::string& name, int width, int height)
    : pictures_(pictures) {
  pictures.add(name, rgbImage(width, height));
}

void WindowReport::progress(double share, std::uint64_t samples) {
  last_.share = share;
  last_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  last_.samplesPerSecond =
      static_cast<double>(samples - firstSamples_) / (last_.seconds - first_.seconds);
  if (first_.seconds == 0.0) {
    first_ = last_;
    firstSamples_ = samples;
  }
  pictures_.report(last_);
}

void WindowReport::end(const Image& picture) {
  last_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  last_.over = true;
  pictures_.replace(picture);
  pictures_.report(last_);
}

}  // namespace laver
