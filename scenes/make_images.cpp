// Writes the images of the ready scenes: make_images FOLDER
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numbers>

#include "image/io.h"
#include "image/srgb.h"

namespace {

using laver::Bitmap;
using laver::Image;
using std::numbers::pi;

/// Waves that repeat without a seam, in warm colours.
Bitmap waves(int size) {
  Bitmap bitmap(size, size, {});
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double s = 2 * pi * x / size, t = 2 * pi * y / size;
      const double a = 0.5 + 0.5 * std::sin(3 * s + 1.5 * std::sin(2 * t));
      const double b = 0.5 + 0.5 * std::cos(2 * t - std::sin(s));
      const auto byte = [](double x01) { return laver::srgb8(static_cast<float>(x01)); };
      bitmap.at(x, y) = {byte(0.15 + 0.7 * a), byte(0.1 + 0.5 * a * b), byte(0.1 + 0.3 * b)};
    }
  return bitmap;
}

/// A dark ground, a bright horizon, a blue zenith and a glow in the direction +x.
Image sky(int height) {
  Image image = laver::rgbImage(2 * height, height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double theta = pi * (y + 0.5) / image.height;
      const double phi = 2 * pi * (x + 0.5) / image.width;
      const double up = std::cos(theta), east = std::sin(theta) * std::sin(phi);
      const double haze = std::exp(-8 * std::abs(up));
      const double glow = 1.5 * std::exp(12 * (east - 1));
      const double day = 1 / (1 + std::exp(-20 * up));
      const double colour[] = {0.08 + 0.10 * day + 0.5 * haze + glow,
                               0.07 + 0.25 * day + 0.4 * haze + 0.7 * glow,
                               0.06 + 0.55 * day + 0.3 * haze + 0.3 * glow};
      for (std::size_t c = 0; c < 3; ++c) image.at(x, y, c) = static_cast<float>(colour[c]);
    }
  return image;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: make_images FOLDER\n", stderr);
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    laver::writePng(folder / "waves.png", waves(128));
    laver::writeExr(folder / "sky.exr", sky(128));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "make_images: %s\n", error.what());
    return 1;
  }
  return 0;
}
