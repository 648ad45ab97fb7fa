#include "commands/observers.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <future>
#include <iostream>

#include "commands/process.h"
#include "show/window.h"

namespace laver {

Progress::Progress(bool wanted) : active_(wanted && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { wipe(); }

void Progress::progress(double share, std::uint64_t /*samples*/) {
  const auto now = Clock::now();
  if (!active_ || now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  shown_ = true;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double left = share > 0.0 ? elapsed * (1.0 - share) / share : 0.0;
  fmt::print(stderr, "\r\x1b[K{:5.1f} %  {:.1f} s elapsed, {:.1f} s remaining", share * 100.0,
             elapsed, left);
  std::fflush(stderr);
}

void Progress::wipe() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
  shown_ = false;
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

void WindowReport::finished(const Image& picture) {
  last_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  last_.over = true;
  pictures_.replace(picture);
  pictures_.report(last_);
}

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

}  // namespace laver
