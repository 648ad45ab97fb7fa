#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace laver {

/// A floating-point image, row-major from the top left, channels interleaved.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< names, such as R G B
  std::vector<float> pixels;          ///< width * height * channels.size()

  float& at(int x, int y, std::size_t channel) {
    return pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(x)) *
                      channels.size() +
                  channel];
  }
  float at(int x, int y, std::size_t channel) const {
    return const_cast<Image*>(this)->at(x, y, channel);
  }
};

/// A black image with channels R, G, B, or with the given ones.
Image rgbImage(int width, int height);
Image blackImage(int width, int height, std::vector<std::string> channels);

/// One image with the channels of all parts, which have the same size.
Image joined(std::vector<Image> parts);

/// The reason why `image` is invalid: no pixels, no channels, a duplicate name, or inconsistent
/// sizes. Empty if it is valid.
std::string imageDefect(const Image& image);

}  // namespace laver
