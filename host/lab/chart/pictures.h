#pragma once
#include <string>

#include "image/image.h"

namespace laver::chart {

/// Pictures that stand in the page, at most so many pixels wide.
inline constexpr int kThumbnail = 96;

/// The picture in sRGB as a data URI of a PNG.
std::string thumbnailOf(const Image& image);

/// The root mean square of the differences in each place, in false colours from 1e-4 to 1.
std::string errorMapOf(const Image& image, const Image& truth);

}  // namespace laver::chart
