#include "show/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <memory>

#include "core/error.h"
#include "core/throttle.h"
#include "show/panels.h"

namespace laver {
namespace {

constexpr double kPollSeconds = 0.05;
/// Share of the time for redrawing when only the render has changed.
constexpr double kRedrawShare = 0.02;
/// Dear ImGui needs a second frame to settle after an event.
constexpr int kFramesPerEvent = 2;

[[noreturn]] void refuse() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw Error(ExitCode::Device,
              fmt::format("no window: {}", reason == nullptr ? "GLFW gives no reason" : reason));
}

struct Glfw {
  Glfw() {
    if (glfwInit() != GLFW_TRUE) refuse();
  }
  ~Glfw() { glfwTerminate(); }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;
};

struct DestroyWindow {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, DestroyWindow>;

struct Gui {
  explicit Gui(GLFWwindow* window) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window, true);  // its callbacks call the earlier ones, too
    ImGui_ImplOpenGL3_Init("#version 130");
  }
  ~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
};

/// Opens a window with room for the image at zoom 1 and the panel, limited by the screen.
WindowHandle openWindow(const std::string& title, glm::ivec2 picture) {
  glm::ivec2 available(1280, 720), corner;
  if (GLFWmonitor* monitor = glfwGetPrimaryMonitor())
    glfwGetMonitorWorkarea(monitor, &corner.x, &corner.y, &available.x, &available.y);
  const glm::ivec2 smallest(800, 300 + kPanelHeight);
  const glm::ivec2 size =
      glm::min(glm::max(picture + glm::ivec2(0, kPanelHeight), smallest), available);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 0);
  WindowHandle window(glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr));
  if (window == nullptr) refuse();
  glfwMakeContextCurrent(window.get());
  return window;
}

class Window {
 public:
  Window(const std::string& title, const ViewedPictures& pictures)
      : pictures_(pictures), window_(openWindow(title, sizeOf(pictures))) {
    glfwSetWindowUserPointer(window_.get(), this);
    listen();
    gui_.emplace(window_.get());
    image_.emplace();
  }

  void run(const std::function<bool()>& over) {
    while (glfwWindowShouldClose(window_.get()) != GLFW_TRUE && !over()) {
      if (frames_ > 0) {
        --frames_;
        draw();
      } else if (redrawDue()) {
        redraw_.run([this] { draw(); });
      }
      frames_ > 0 ? glfwPollEvents() : glfwWaitEventsTimeout(kPollSeconds);
    }
  }

 private:
  static glm::ivec2 sizeOf(const ViewedPictures& pictures) {
    return pictures.read([](const auto& contents) {
      return glm::ivec2(contents.images[0].width, contents.images[0].height);
    });
  }

  static Window& of(GLFWwindow* window) {
    auto& self = *static_cast<Window*>(glfwGetWindowUserPointer(window));
    self.frames_ = kFramesPerEvent;
    return self;
  }

  void listen() {
    GLFWwindow* const window = window_.get();
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) { of(w).typed(character); });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
      of(w);
      if (key == GLFW_KEY_ESCAPE && action == GLFW_PRESS) glfwSetWindowShouldClose(w, GLFW_TRUE);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double steps) {
      of(w).view_.placement.zoomAt(of(w).cursor_, steps > 0.0 ? 1 : -1);
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { of(w); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { of(w).move({x, y}); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w); });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w); });
  }

  void typed(char32_t character) {
    if (character == U'q') glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
    pictures_.read([this](const auto& contents) { updateContext(contents); });
    type(view_, character, context_);
  }

  void move(glm::dvec2 cursor) {
    const bool dragged = glfwGetMouseButton(window_.get(), GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    if (dragged && !ImGui::GetIO().WantCaptureMouse) view_.placement.pan(cursor - cursor_);
    cursor_ = cursor;
  }

  /// Whether to redraw because of the render: if it has changed and is due, or at its end.
  bool redrawDue() const {
    return pictures_.read([this](const auto& contents) {
      const bool changed = contents.changes != changes_ || contents.rendering.seconds != seconds_;
      return changed && (contents.rendering.over || redraw_.due());
    });
  }

  void updateContext(const ViewedPictures::Contents& contents) {
    context_.layers = viewLayers(contents.images[0].channels).size();
    context_.two = contents.images.size() > 1;
    context_.cursor = cursor_;
  }

  /// Centres the image at first; keeps its centre when the window is resized.
  void place(const Image& picture, glm::ivec2 size) {
    const glm::ivec2 pixels(picture.width, picture.height);
    if (!view_.placed)
      view_.placement.centre(pixels, size, glm::any(glm::greaterThan(pixels, size)));
    else
      view_.placement.pan(size / 2 - context_.window / 2);
    view_.placed = true;
    context_.picture = pixels;
    context_.window = size;
  }

  void draw() {
    glm::ivec2 size;
    glfwGetFramebufferSize(window_.get(), &size.x, &size.y);
    if (size.x == 0 || size.y <= kPanelHeight) return;  // minimised
    size.y -= kPanelHeight;
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    pictures_.read([&](const auto& contents) { drawContents(contents, size); });
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_.get());
  }

  void drawContents(const ViewedPictures::Contents& contents, glm::ivec2 size) {
    const auto layers = viewLayers(contents.images[0].channels);
    updateContext(contents);
    place(contents.images[0], size);
    const bool inside = cursor_.x < size.x && cursor_.y < size.y;
    drawPanel(contents, layers, inside ? pixelUnderCursor(view_, context_) : std::nullopt, size.x,
              size.y, view_);
    image_->draw(contents, layers[view_.layer], view_, size);
    changes_ = contents.changes;
    seconds_ = contents.rendering.seconds;
  }

  const ViewedPictures& pictures_;
  Glfw glfw_;
  WindowHandle window_;
  std::optional<Gui> gui_;
  std::optional<ImageView> image_;
  View view_;
  ViewContext context_;
  glm::dvec2 cursor_{-1.0};
  int frames_ = kFramesPerEvent;  ///< still to draw at once
  std::uint64_t changes_ = 0;     ///< of the contents that were drawn last
  double seconds_ = 0.0;
  Throttle redraw_{kRedrawShare};
};

}  // namespace

void runWindow(const std::string& title, const ViewedPictures& pictures,
               const std::function<bool()>& over) {
  Window(title, pictures).run(over);
}

}  // namespace laver
