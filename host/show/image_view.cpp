#include "show/image_view.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "show/compose.h"

namespace laver {

ImageView::ImageView() {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

ImageView::~ImageView() { glDeleteTextures(1, &texture_); }

void ImageView::draw(const ViewedPictures::Contents& contents, const ViewLayer& layer,
                     const View& view, glm::ivec2 size) {
  const Drawn wanted{contents.changes, view, size};
  if (drawn_ != wanted) {
    const auto& images = contents.images;
    const Bitmap bitmap =
        compose(images[0], images.size() > 1 ? &images[1] : nullptr, layer, view, size.x, size.y);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, size.x, size.y, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 bitmap.pixels.data());
    drawn_ = wanted;
  }
  // NOLINTNEXTLINE(performance-no-int-to-ptr): what ImGui's OpenGL backend takes
  const auto texture = reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_));
  ImGui::GetBackgroundDrawList()->AddImage(
      texture, {0.0F, 0.0F}, {static_cast<float>(size.x), static_cast<float>(size.y)});
}

}  // namespace laver
