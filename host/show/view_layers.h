#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver {

/// Channels that are shown together: three as red, green and blue, two as red and green, one grey.
struct ViewLayer {
  std::string name;
  std::vector<std::size_t> channels;  ///< places in the picture's
};

/// Groups R G B, X Y Z and u v of one prefix ("N." of N.X); every other channel is by itself.
/// In the order of the channels.
std::vector<ViewLayer> viewLayers(const std::vector<std::string>& channels);

/// Leaves both pictures with the channels that they share, in a's order. Throws Error(Usage) if
/// their sizes differ or they share none.
void keepShared(Image& a, Image& b);

}  // namespace laver
