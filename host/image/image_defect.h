#pragma once
#include <string>

#include "image/image.h"

namespace laver {

/// Why `image` is not a picture: no pixels, no channels, a name twice, or sizes that disagree.
/// Empty when it is one.
std::string imageDefect(const Image& image);

}  // namespace laver
