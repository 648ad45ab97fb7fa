#pragma once
#include <sys/types.h>

#include <optional>
#include <string>

#include "image/bitmap.h"

namespace laver::test {

/// An X server without a screen, Xvfb, and the one window on it, observed and operated from
/// outside. DISPLAY names it during the object's lifetime.
class Screen {
 public:
  /// Throws std::runtime_error without Xvfb.
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// The contents of the window; none if there is no window.
  std::optional<Bitmap> window() const;
  /// Types a lower-case letter.
  void type(char letter) const;
  void moveCursor(int x, int y) const;
  /// Closes the window as a window manager does.
  void close() const;

 private:
  struct Connection;
  pid_t server_ = -1;
  Connection* connection_ = nullptr;
};

}  // namespace laver::test
