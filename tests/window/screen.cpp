#include "window/screen.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace laver::test {
namespace {

/// Bounds waiting only: Xvfb starts within a second.
constexpr int kServerMilliseconds = 60000;

}  // namespace

struct Screen::Connection {
  Display* display;

  /// The first visible window; 0 if there is none.
  Window window() const {
    Window root = 0, parent = 0, found = 0;
    Window* children = nullptr;
    unsigned count = 0;
    XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count);
    for (unsigned i = 0; i < count && found == 0; ++i) {
      XWindowAttributes attributes;
      XGetWindowAttributes(display, children[i], &attributes);
      if (attributes.map_state == IsViewable) found = children[i];
    }
    if (children != nullptr) XFree(children);
    return found;
  }
  void send(XEvent& event, Window window) const {
    event.xany.window = window;
    XSendEvent(display, window, False, NoEventMask, &event);
    XFlush(display);
  }
};

Screen::Screen() {
  int ends[2] = {-1, -1};
  if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
  server_ = ::fork();
  if (server_ == 0) {
    ::close(ends[0]);
    const std::string end = std::to_string(ends[1]);
    ::execlp("Xvfb", "Xvfb", "-displayfd", end.c_str(), "-screen", "0", "1280x1024x24", "-nolisten",
             "tcp", static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(ends[1]);
  std::string number;
  pollfd ready{ends[0], POLLIN, 0};
  for (char c = 0;
       ::poll(&ready, 1, kServerMilliseconds) > 0 && ::read(ends[0], &c, 1) == 1 && c != '\n';)
    number += c;
  ::close(ends[0]);
  if (number.empty()) throw std::runtime_error("Xvfb does not start; is the package xvfb there?");
  ::setenv("DISPLAY", (":" + number).c_str(), 1);
  Display* const display = XOpenDisplay(nullptr);
  if (display == nullptr) throw std::runtime_error("Xvfb cannot be reached");
  // A window may disappear during a query.
  XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
  connection_ = new Connection{display};
}

Screen::~Screen() {
  if (connection_ != nullptr) XCloseDisplay(connection_->display);
  delete connection_;
  ::unsetenv("DISPLAY");
  ::kill(server_, SIGTERM);
  ::waitpid(server_, nullptr, 0);
}

std::optional<Bitmap> Screen::window() const {
  Display* const display = connection_->display;
  const Window window = connection_->window();
  XWindowAttributes size;
  if (window == 0 || XGetWindowAttributes(display, window, &size) == 0) return std::nullopt;
  XImage* const image = XGetImage(display, window, 0, 0, static_cast<unsigned>(size.width),
                                  static_cast<unsigned>(size.height), AllPlanes, ZPixmap);
  if (image == nullptr) return std::nullopt;
  Bitmap bitmap(size.width, size.height, {});
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const unsigned long pixel = XGetPixel(image, x, y);
      bitmap.at(x, y) = {static_cast<std::uint8_t>(pixel >> 16),
                         static_cast<std::uint8_t>(pixel >> 8), static_cast<std::uint8_t>(pixel)};
    }
  XDestroyImage(image);
  return bitmap;
}

void Screen::type(char letter) const {
  const Window window = connection_->window();
  for (const int kind : {KeyPress, KeyRelease}) {
    XEvent event{};
    event.xkey.type = kind;
    event.xkey.display = connection_->display;
    event.xkey.root = DefaultRootWindow(connection_->display);
    event.xkey.same_screen = True;
    const char name[] = {letter, '\0'};
    event.xkey.keycode = XKeysymToKeycode(connection_->display, XStringToKeysym(name));
    connection_->send(event, window);
  }
}

void Screen::moveCursor(int x, int y) const {
  XWarpPointer(connection_->display, 0, connection_->window(), 0, 0, 0, 0, x, y);
  XFlush(connection_->display);
}

void Screen::close() const {
  Display* const display = connection_->display;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));
  connection_->send(event, connection_->window());
}

}  // namespace laver::test
