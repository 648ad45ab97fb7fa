#include "image/image_defect.h"

#include <fmt/format.h>

#include <set>

namespace laver {

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
