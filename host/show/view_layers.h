#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver {

/// Channels that are displayed together: three as red, green and blue, two as red and green, one as
/// grey.
struct ViewLayer {
  std::string name;
  std::vector<std::size_t> channels;  ///< indices into the image's channels
};

/// Groups R G B, X Y Z and u v that share a prefix ("N." of N.X); every other channel is a layer of
/// its own. In the order of the channels.
std::vector<ViewLayer> viewLayers(const std::vector<std::string>& channels);

/// Reduces both images to the channels that they share, in a's order. Throws Error(Usage) if their
/// sizes differ or they share none.
void keepShared(Image& a, Image& b);

}  // namespace laver
