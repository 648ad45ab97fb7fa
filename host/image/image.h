#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace laver {

/// Where an image lies on a film of which it may be a part.
struct FilmWindow {
  int x = 0, y = 0;                   ///< its top left pixel
  int filmWidth = 0, filmHeight = 0;  ///< 0: as the image
  bool operator==(const FilmWindow&) const = default;
};

/// A floating-point image, row-major from the top left, channels interleaved.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;  ///< names, such as R G B
  std::vector<float> pixels;          ///< width * height * channels.size()
  FilmWindow window{};

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

/// The whole film of an image that is a part of it, black elsewhere; the image itself where the
/// film would have more than 2^28 numbers.
Image onFilm(Image image);

/// Cuts images of different parts of one film to the part that both have. True if that was
/// necessary; images of different films are left alone.
bool cutToShared(Image& a, Image& b);

/// An image all of whose channels have prefixes, and R, G, B one such as "diffuse.R": without it.
Image withoutPrefix(Image image);

/// One image with the channels of all parts, which have the same size.
Image joined(std::vector<Image> parts);

/// The reason why `image` is invalid: no pixels, no channels, a duplicate name, or inconsistent
/// sizes. Empty if it is valid.
std::string imageDefect(const Image& image);

}  // namespace laver
