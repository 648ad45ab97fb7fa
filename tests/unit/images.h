#pragma once
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "image/image.h"

namespace laver::test {

inline constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr double kEndless = std::numeric_limits<double>::infinity();

/// An image of one row.
inline Image row(std::vector<std::string> channels, std::vector<float> pixels) {
  Image image;
  image.width = static_cast<int>(pixels.size() / channels.size());
  image.height = 1;
  image.channels = std::move(channels);
  image.pixels = std::move(pixels);
  return image;
}

}  // namespace laver::test
