#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "show/view.h"
#include "show/view_layers.h"
#include "show/viewed_pictures.h"

// The parts of a window: the picture and the panel below it.
namespace laver {

/// The part of the window that shows a picture, as an OpenGL texture of the window's size. Lives
/// while the context is current.
class ImageView {
 public:
  ImageView();
  ~ImageView();
  ImageView(const ImageView&) = delete;
  ImageView& operator=(const ImageView&) = delete;

  /// Draws behind all of Dear ImGui's windows, from the top left corner.
  void draw(const ViewedPictures::Contents& contents, const ViewLayer& layer, const View& view,
            glm::ivec2 size);

 private:
  struct Drawn {
    std::uint64_t changes;
    View view;
    glm::ivec2 size;
    bool operator==(const Drawn&) const = default;
  };
  unsigned texture_ = 0;
  std::optional<Drawn> drawn_;  ///< what the texture holds
};

/// Height of the panel in pixels.
inline constexpr int kPanelHeight = 96;

/// The panel along the window's lower edge, `width` pixels wide from (0, top): what is shown, what
/// is under the cursor, how far the rendering is. Its buttons change the view.
void drawPanel(const ViewedPictures::Contents& contents, const std::vector<ViewLayer>& layers,
               std::optional<glm::ivec2> pixel, int width, int top, View& view);

}  // namespace laver
