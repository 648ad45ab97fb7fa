#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace laver::xml {
namespace {
constexpr std::size_t kMaxLength = 64;

std::string lowerCase(std::string_view name) {
  std::string lower(name.substr(0, kMaxLength));
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

}  // namespace

std::size_t editDistance(std::string_view a, std::string_view b) {
  a = a.substr(0, kMaxLength);
  b = b.substr(0, kMaxLength);
  using Row = std::array<std::size_t, kMaxLength + 1>;
  Row previous{}, before{}, row{};
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replace, previous[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = previous;
    previous = row;
  }
  return previous[b.size()];
}

std::string_view nearest(std::string_view name, const std::vector<std::string_view>& candidates) {
  std::string_view best;
  std::size_t bestDistance = 3;
  const std::string lower = lowerCase(name);
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = editDistance(lower, lowerCase(candidate));
    if (distance < bestDistance && distance * 3 <= std::max(name.size(), candidate.size())) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string expectedNames(std::string_view name, const std::vector<std::string_view>& candidates) {
  std::string list;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i > 0) list += i + 1 == candidates.size() ? " or " : ", ";
    list += fmt::format("\"{}\"", candidates[i]);
  }
  const std::string_view hint = nearest(name, candidates);
  if (candidates.size() > 1 && !hint.empty()) list += fmt::format(" (nearest: \"{}\")", hint);
  return list;
}

}  // namespace laver::xml
