#pragma once
#include <functional>
#include <string>

#include "show/viewed_pictures.h"

namespace laver {

/// Shows `pictures`, of which there is at least one, until the window is closed or `over()`, which
/// is asked some twenty times a second. For the main thread. Throws Error(Device) where no window
/// can be opened.
void runWindow(const std::string& title, const ViewedPictures& pictures,
               const std::function<bool()>& over);

}  // namespace laver
