#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace laver {

/// Floating-point picture, row-major from the top left, channels interleaved.
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

/// A black picture with channels R, G, B, or others.
Image rgbImage(int width, int height);
Image blackImage(int width, int height, std::vector<std::string> channels);

/// One picture with the channels of all, which have the same size.
Image joined(std::vector<Image> parts);

/// Why `image` is not a picture: no pixels, no channels, a name twice, or sizes that disagree.
/// Empty when it is one.
std::string imageDefect(const Image& image);

}  // namespace laver
