// SIGKILL at many moments of a run leaves either the old or the new picture.
#include <poll.h>
#include <sys/inotify.h>

#include <chrono>
#include <thread>

#include "image/io.h"
#include "pictures/child.h"
#include "pictures/command_line.h"
#include "pictures/harness.h"

namespace laver::test {
namespace {

/// Counts events on the files of a folder.
class Watch {
 public:
  explicit Watch(const fs::path& folder) : queue_(::inotify_init1(IN_NONBLOCK)) {
    ::inotify_add_watch(queue_.get(), folder.c_str(),
                        IN_CREATE | IN_MODIFY | IN_DELETE | IN_MOVED_TO);
  }
  /// Waits for `events` events; false if the child ended before.
  bool wait(int events, Child& child) {
    for (int seen = 0; seen < events;) {
      pollfd ready{queue_.get(), POLLIN, 0};
      if (::poll(&ready, 1, 20) > 0)
        seen += take();
      else if (child.ended())
        return false;
    }
    return true;
  }

 private:
  int take() {
    alignas(inotify_event) char buffer[4096];
    const ssize_t size = ::read(queue_.get(), buffer, sizeof buffer);
    int count = 0;
    for (ssize_t at = 0; at < size; ++count) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer + at);
      at += static_cast<ssize_t>(sizeof *event + event->len);
    }
    return count;
  }
  Descriptor queue_;
};

class Kill : public CommandLine {
 protected:
  /// Arguments that render one of two pictures, chosen by `seed`.
  static std::vector<std::string> arguments(int seed) {
    return {(scenesFolder() / "curved-normals.xml").string(),
            "--reference",
            "--quiet",
            "--size",
            "300x300",
            "--spp",
            "1",
            "--integrator",
            "normals",
            "--seed",
            std::to_string(seed),
            "-o",
            "a.exr"};
  }
  void expectOldOrNew() {
    const std::vector<float> pixels = readExr(path("a.exr")).pixels;
    EXPECT_TRUE(pixels == exr_[0] || pixels == exr_[1]);
    const std::string png = contents(path("a.png"));
    EXPECT_TRUE(png == png_[0] || png == png_[1]);
  }

  std::vector<float> exr_[2];
  std::string png_[2];
};

TEST_F(Kill, LeavesTheOldPictureOrTheNewOne) {
  using Clock = std::chrono::steady_clock;
  Clock::duration whole{};
  for (const int seed : {0, 1}) {
    const auto start = Clock::now();
    ASSERT_EQ(Child(folder_, arguments(seed)).wait(), 0) << contents(folder_ / "err.txt");
    whole = Clock::now() - start;
    exr_[seed] = readExr(path("a.exr")).pixels;
    png_[seed] = contents(path("a.png"));
  }
  ASSERT_NE(exr_[0], exr_[1]);
  ASSERT_NE(png_[0], png_[1]);

  // Moments spread evenly over the duration of a run and a little more.
  constexpr int kMoments = 24;
  for (int moment = 1; moment <= kMoments && !HasFailure(); ++moment) {
    Child child(folder_, arguments(moment % 2));
    std::this_thread::sleep_for(whole * moment / (kMoments - 2));
    child.send(SIGKILL);
    child.wait();
    expectOldOrNew();
  }
  // Moments after each file operation: two files are probed, then two are created, written and
  // renamed.
  for (int events = 1; events <= 14 && !HasFailure(); ++events) {
    for (const int seed : {0, 1}) {
      Watch watch(folder_);
      Child child(folder_, arguments(seed));
      watch.wait(2 + events, child);  // two events for out.txt and err.txt
      child.send(SIGKILL);
      child.wait();
      expectOldOrNew();
    }
  }
  ASSERT_EQ(Child(folder_, arguments(0)).wait(), 0);
  EXPECT_EQ(readExr(path("a.exr")).pixels, exr_[0]);
  EXPECT_EQ(files(), (std::set<std::string>{"a.exr", "a.png"}));  // killed runs left nothing
}

}  // namespace
}  // namespace laver::test
