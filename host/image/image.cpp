#include "image/image.h"

namespace laver {

Image rgbImage(int width, int height) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = {"R", "G", "B"};
  image.pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3, 0.0f);
  return image;
}

}  // namespace laver
