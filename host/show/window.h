#pragma once
#include <functional>
#include <string>

#include "show/viewed_pictures.h"

// host/show shows pictures: in a window (GLFW, OpenGL, Dear ImGui) and in viewers that listen on
// TCP (tev, HDRView). ViewedPictures is what is shown, View how; compose() turns them into pixels
// without a graphics library, and window and panels draw those.
namespace laver {

/// Shows `pictures`, of which there is at least one, until the window is closed or `over()`, which
/// is asked some twenty times a second. For the main thread. Throws Error(Device) where no window
/// can be opened.
void runWindow(const std::string& title, const ViewedPictures& pictures,
               const std::function<bool()>& over);

}  // namespace laver
