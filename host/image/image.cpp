#include "image/image.h"

#include <algorithm>
#include <utility>

namespace laver {

Image rgbImage(int width, int height) { return blackImage(width, height, {"R", "G", "B"}); }

Image blackImage(int width, int height, std::vector<std::string> channels) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = std::move(channels);
  image.pixels.assign(
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * image.channels.size(),
      0.0f);
  return image;
}

Image joined(std::vector<Image> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  Image all;
  all.width = parts.front().width;
  all.height = parts.front().height;
  for (const Image& part : parts)
    all.channels.insert(all.channels.end(), part.channels.begin(), part.channels.end());
  const std::size_t count =
      static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height);
  const std::size_t stride = all.channels.size();
  all.pixels.resize(count * stride);
  std::size_t first = 0;
  for (Image& part : parts) {
    const std::size_t channels = part.channels.size();
    for (std::size_t i = 0; i < count; ++i)
      std::copy_n(&part.pixels[i * channels], channels, &all.pixels[i * stride + first]);
    first += channels;
    part.pixels = {};
  }
  return all;
}

}  // namespace laver
