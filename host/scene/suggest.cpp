#include "scene/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace laver::xml {
namespace {
constexpr std::size_t kMaxLength = 64;
}

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
  std::size_t bestDistance = 2 * kMaxLength;
  for (const std::string_view candidate : candidates) {
    const std::size_t distance = editDistance(name, candidate);
    if (distance < bestDistance) {
      bestDistance = distance;
      best = candidate;
    }
  }
  return best;
}

bool looksLikeTypo(std::string_view name, std::string_view known) {
  return editDistance(name, known) * 3 <= std::max(name.size(), known.size());
}

std::string expectedNames(std::string_view name, const std::vector<std::string_view>& candidates) {
  std::string list;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i > 0) list += i + 1 == candidates.size() ? " or " : ", ";
    list += fmt::format("\"{}\"", candidates[i]);
  }
  if (candidates.size() > 1 && !name.empty())
    list += fmt::format(" (nearest: \"{}\")", nearest(name, candidates));
  return list;
}

}  // namespace laver::xml
