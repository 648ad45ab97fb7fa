// Replaces window.cpp and panels.cpp where GLFW or Dear ImGui is missing.
#include "core/error.h"
#include "show/window.h"

namespace laver {

void runWindow(const std::string&, const ViewedPictures&, const std::function<bool()>&) {
  throw Error(ExitCode::Device, "no window: this laver was built without GLFW and Dear ImGui");
}

}  // namespace laver
