#pragma once
#include <functional>
#include <string>

#include "show/viewed_pictures.h"

// host/show displays images: in a window (GLFW, OpenGL, Dear ImGui) and in viewers that listen on
// TCP (tev, HDRView). ViewedPictures holds the images, View the state of the window; compose()
// turns both into pixels without a graphics library, and window and panels draw those.
namespace laver {

/// Shows `pictures`, at least one, until the window is closed or `over()` returns true; it is
/// called about twenty times per second. For the main thread. Throws Error(Device) if no window can
/// be opened.
void runWindow(const std::string& title, const ViewedPictures& pictures,
               const std::function<bool()>& over);

}  // namespace laver
