#include "image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
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

std::string imageDefect(const Image& image) {
  if (image.width <= 0 || image.height <= 0) {
    return fmt::format("its size is {} x {} pixels", image.width, image.height);
  }
  if (image.channels.empty()) return "it has no channels";
  std::set<std::string> seen;
  for (const std::string& name : image.channels) {
    if (!seen.insert(name).second) return fmt::format("channel \"{}\" occurs twice", name);
  }
  const std::size_t expected = static_cast<std::size_t>(image.width) *
                               static_cast<std::size_t>(image.height) * image.channels.size();
  if (image.pixels.size() == expected) return {};
  return fmt::format("it holds {} numbers, not {}", image.pixels.size(), expected);
}

}  // namespace laver
