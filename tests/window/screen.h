#pragma once
#include <sys/types.h>

#include <optional>
#include <string>

#include "image/bitmap.h"

namespace laver::test {

/// An X server without a screen, Xvfb, and the one window on it, seen and typed into from outside.
/// DISPLAY names it while it lives.
class Screen {
 public:
  /// Throws std::runtime_error without Xvfb.
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// What the window shows; none if there is no window.
  std::optional<Bitmap> window() const;
  /// As if typed: a lower-case letter.
  void type(char letter) const;
  void moveCursor(int x, int y) const;
  /// As a window manager asks.
  void close() const;

 private:
  struct Connection;
  pid_t server_ = -1;
  Connection* connection_ = nullptr;
};

}  // namespace laver::test
