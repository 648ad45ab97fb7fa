#include "image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "core/error.h"

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

namespace {

/// The rectangle of a film, which the picture covers or not; black outside of the picture.
Image cut(const Image& image, int x0, int y0, int width, int height) {
  Image result = blackImage(width, height, image.channels);
  const FilmWindow& w = image.window;
  result.window = {x0, y0, w.filmWidth, w.filmHeight};
  const int left = std::max(x0, w.x), right = std::min(x0 + width, w.x + image.width);
  const int top = std::max(y0, w.y), bottom = std::min(y0 + height, w.y + image.height);
  const std::size_t stride = image.channels.size();
  for (int y = top; y < bottom && left < right; ++y) {
    const auto begin = static_cast<std::ptrdiff_t>(
        (static_cast<std::size_t>(y - w.y) * static_cast<std::size_t>(image.width) +
         static_cast<std::size_t>(left - w.x)) *
        stride);
    std::copy_n(image.pixels.begin() + begin, static_cast<std::size_t>(right - left) * stride,
                &result.at(left - x0, y - y0, 0));
  }
  return result;
}

}  // namespace

Image onFilm(Image image) {
  const FilmWindow& w = image.window;
  const bool whole =
      w.x == 0 && w.y == 0 && w.filmWidth == image.width && w.filmHeight == image.height;
  constexpr double kMostNumbers = 1 << 28;
  if (w.filmWidth <= 0 || w.filmHeight <= 0 || whole ||
      static_cast<double>(w.filmWidth) * w.filmHeight * static_cast<double>(image.channels.size()) >
          kMostNumbers)
    return image;
  return cut(image, 0, 0, w.filmWidth, w.filmHeight);
}

bool cutToShared(Image& a, Image& b) {
  const auto film = [](const Image& image) {
    return std::pair(image.window.filmWidth, image.window.filmHeight);
  };
  const bool alike = a.window == b.window && a.width == b.width && a.height == b.height;
  if (alike || film(a) != film(b) || a.window.filmWidth == 0) return false;
  const int x0 = std::max(a.window.x, b.window.x), y0 = std::max(a.window.y, b.window.y);
  const int x1 = std::min(a.window.x + a.width, b.window.x + b.width);
  const int y1 = std::min(a.window.y + a.height, b.window.y + b.height);
  if (x0 >= x1 || y0 >= y1)
    throw Error(ExitCode::Usage, "the pictures are of parts of the film that do not overlap");
  for (Image* image : {&a, &b}) *image = cut(*image, x0, y0, x1 - x0, y1 - y0);
  return true;
}

Image withoutPrefix(Image image) {
  std::set<std::string> names(image.channels.begin(), image.channels.end());
  std::vector<std::string> prefixes;
  for (const std::string& name : names) {
    if (name.find('.') == std::string::npos) return image;
    const std::string prefix = name.substr(0, name.size() - 1);
    if (name.ends_with(".R") && names.contains(prefix + "G") && names.contains(prefix + "B"))
      prefixes.push_back(prefix);
  }
  if (prefixes.size() != 1) return image;
  for (std::string& name : image.channels)
    if (name.starts_with(prefixes.front())) name.erase(0, prefixes.front().size());
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
