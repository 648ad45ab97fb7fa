#include "reference/filter.h"

#include <algorithm>
#include <cmath>

namespace laver::reference {

FilterWeights::FilterWeights(const Filter& filter, bool noriCompat)
    : filter_(filter), noriCompat_(noriCompat) {
  const auto radius = static_cast<float>(filter.radius);
  for (int i = 0; i < resolution; ++i) {
    table_[static_cast<std::size_t>(i)] = filter.row->twin->single(
        filter, radius * static_cast<float>(i) / static_cast<float>(resolution));
  }
}

double FilterWeights::operator()(double distance) const {
  distance = std::abs(distance);
  if (!(distance <= filter_.radius)) return 0.0;
  if (!noriCompat_) return filter_.row->twin->exact(filter_, distance);
  const float factor = static_cast<float>(resolution) / static_cast<float>(filter_.radius);
  const auto entry = static_cast<int>(static_cast<float>(distance) * factor);
  return static_cast<double>(table_[static_cast<std::size_t>(std::min(entry, resolution))]);
}

int FilterWeights::reach() const { return static_cast<int>(std::floor(filter_.radius + 0.5)); }

}  // namespace laver::reference
