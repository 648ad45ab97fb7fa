#pragma once
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "show/view.h"
#include "show/view_layers.h"
#include "show/viewed_pictures.h"

// The parts of a window: the picture and the panel below it.
namespace laver {

/// The area of the window that shows an image, as an OpenGL texture of the same size. Must be
/// destroyed while the OpenGL context is current.
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
  std::optional<Drawn> drawn_;  ///< contents of the texture
};

/// Height of the panel in pixels.
inline constexpr int kPanelHeight = 96;

/// Draws the panel along the window's lower edge, `width` pixels wide from (0, top): buttons that
/// change the view, values under the cursor, progress of the render.
void drawPanel(const ViewedPictures::Contents& contents, const std::vector<ViewLayer>& layers,
               std::optional<glm::ivec2> pixel, int width, int top, View& view);

}  // namespace laver
