#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "show/view.h"
#include "show/view_layers.h"
#include "show/viewed_pictures.h"

namespace laver {

/// Height of the panel in pixels.
inline constexpr int kPanelHeight = 96;

/// The panel along the window's lower edge, `width` pixels wide from (0, top): what is shown, what
/// is under the cursor, how far the rendering is. Its buttons change the view.
void drawPanel(const ViewedPictures::Contents& contents, const std::vector<ViewLayer>& layers,
               std::optional<glm::ivec2> pixel, int width, int top, View& view);

}  // namespace laver
