#include "show/viewed_pictures.h"

#include <algorithm>
#include <utility>

namespace laver {

void ViewedPictures::add(std::string name, Image image) {
  const std::lock_guard lock(mutex_);
  contents_.names.push_back(std::move(name));
  contents_.images.push_back(std::move(image));
}

void ViewedPictures::rowsChanged(const Image& picture, int firstRow, int endRow) {
  const std::ptrdiff_t stride =
      picture.width * static_cast<std::ptrdiff_t>(picture.channels.size());
  const auto first = picture.pixels.begin() + firstRow * stride;
  const std::lock_guard lock(mutex_);
  std::copy(first, first + (endRow - firstRow) * stride,
            contents_.images.front().pixels.begin() + firstRow * stride);
  ++contents_.changes;
}

void ViewedPictures::replace(const Image& picture) {
  const std::lock_guard lock(mutex_);
  contents_.images.front() = picture;
  ++contents_.changes;
}

void ViewedPictures::report(const Rendering& rendering) {
  const std::lock_guard lock(mutex_);
  contents_.rendering = rendering;
  contents_.rendered = true;
}

}  // namespace laver
