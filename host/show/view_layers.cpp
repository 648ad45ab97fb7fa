#include "show/view_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/error.h"

namespace laver {
namespace {

using Names = std::vector<std::string>;

struct Group {
  Names parts;
  const char* name;  ///< of a layer without a prefix; else the prefix is the name
};
const std::array kGroups = {Group{{"R", "G", "B"}, "RGB"}, Group{{"X", "Y", "Z"}, "XYZ"},
                            Group{{"u", "v"}, "uv"}};

std::optional<std::size_t> place(const Names& channels, const std::string& name) {
  const auto found = std::find(channels.begin(), channels.end(), name);
  if (found == channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - channels.begin());
}

/// The layer of channel `i`: its group if all of that is there, else the channel alone.
ViewLayer layerOf(const Names& channels, std::size_t i) {
  const std::string& name = channels[i];
  const std::size_t dot = name.rfind('.');
  const std::string prefix = dot == std::string::npos ? "" : name.substr(0, dot + 1);
  for (const Group& group : kGroups) {
    if (!place(group.parts, name.substr(prefix.size()))) continue;
    ViewLayer layer{prefix.empty() ? group.name : name.substr(0, dot), {}};
    for (const std::string& part : group.parts)
      if (const auto at = place(channels, prefix + part)) layer.channels.push_back(*at);
    if (layer.channels.size() == group.parts.size()) return layer;
  }
  return {name, {i}};
}

Image only(const Image& image, const Names& names) {
  Image result = blackImage(image.width, image.height, names);
  result.window = image.window;
  std::vector<std::size_t> from;
  for (const std::string& name : names) from.push_back(*place(image.channels, name));
  auto out = result.pixels.begin();
  for (std::size_t p = 0; p < image.pixels.size(); p += image.channels.size())
    for (const std::size_t c : from) *out++ = image.pixels[p + c];
  return result;
}

}  // namespace

std::vector<ViewLayer> viewLayers(const std::vector<std::string>& channels) {
  std::vector<ViewLayer> layers;
  std::vector<bool> taken(channels.size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    if (taken[i]) continue;
    layers.push_back(layerOf(channels, i));
    for (const std::size_t c : layers.back().channels) taken[c] = true;
  }
  return layers;
}

void keepShared(Image& a, Image& b) {
  if (a.width != b.width || a.height != b.height)
    throw Error(ExitCode::Usage,
                fmt::format("the pictures differ in size: {} x {} and {} x {} pixels", a.width,
                            a.height, b.width, b.height));
  Names shared;
  for (const std::string& name : a.channels)
    if (place(b.channels, name)) shared.push_back(name);
  if (shared.empty())
    throw Error(ExitCode::Usage,
                fmt::format("the pictures share no channel: {} and {}", fmt::join(a.channels, " "),
                            fmt::join(b.channels, " ")));
  for (Image* image : {&a, &b})
    if (image->channels != shared) *image = only(*image, shared);
}

}  // namespace laver
