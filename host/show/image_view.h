#pragma once
#include <optional>

#include "show/view.h"
#include "show/view_layers.h"
#include "show/viewed_pictures.h"

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

}  // namespace laver
