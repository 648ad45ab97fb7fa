#include "image/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/error.h"
#include "image/image_defect.h"

namespace laver {
namespace {

/// Calls use(i, a, b) for every number of a, at place i in it, and its counterpart in b.
template <class Use>
void forPairs(const Image& a, const Image& b, Use use) {
  requireAlike(a, b);
  const std::vector<std::size_t> channels = matchingChannels(a, b);
  const std::size_t stride = channels.size();
  for (std::size_t p = 0; p < a.pixels.size(); p += stride)
    for (std::size_t c = 0; c < stride; ++c)
      use(p + c, static_cast<double>(a.pixels[p + c]),
          static_cast<double>(b.pixels[p + channels[c]]));
}

}  // namespace

double distance(double a, double b) {
  if (std::isfinite(a) && std::isfinite(b)) return std::abs(a - b);
  const bool alike = a == b || (std::isnan(a) && std::isnan(b));
  return alike ? 0.0 : std::numeric_limits<double>::infinity();
}

void requireAlike(const Image& a, const Image& b) {
  const auto refuse = [](const std::string& reason) { throw Error(ExitCode::Usage, reason); };
  for (const Image* image : {&a, &b}) {
    if (const std::string defect = imageDefect(*image); !defect.empty()) {
      refuse(fmt::format("the {} picture is broken: {}", image == &a ? "first" : "second", defect));
    }
  }
  if (a.width != b.width || a.height != b.height) {
    refuse(fmt::format("the pictures differ in size: {} x {} and {} x {} pixels", a.width, a.height,
                       b.width, b.height));
  }
  const std::set<std::string> first(a.channels.begin(), a.channels.end());
  const std::set<std::string> second(b.channels.begin(), b.channels.end());
  if (first != second) {
    refuse(fmt::format("the pictures differ in channels: {} and {}", fmt::join(first, " "),
                       fmt::join(second, " ")));
  }
}

std::vector<std::size_t> matchingChannels(const Image& a, const Image& b) {
  std::vector<std::size_t> places;
  for (const std::string& name : a.channels)
    places.push_back(static_cast<std::size_t>(
        std::find(b.channels.begin(), b.channels.end(), name) - b.channels.begin()));
  return places;
}

Image difference(const Image& a, const Image& b) {
  Image result = a;
  forPairs(a, b, [&](std::size_t i, double x, double y) {
    result.pixels[i] = distance(x, y) == 0.0 ? 0.0F : static_cast<float>(x - y);
  });
  return result;
}

std::vector<double> largestDistances(const Image& a, const Image& b) {
  std::vector<double> largest(a.pixels.size() / std::max<std::size_t>(a.channels.size(), 1));
  forPairs(a, b, [&](std::size_t i, double x, double y) {
    double& value = largest[i / a.channels.size()];
    value = std::max(value, distance(x, y));
  });
  return largest;
}

}  // namespace laver
