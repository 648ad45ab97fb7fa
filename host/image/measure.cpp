#include "image/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/flip.h"

namespace laver {
namespace {

double valueOf(const ChannelDifference& d, const std::string& metric) {
  if (metric == "rmse") return d.rmse;
  if (metric == "relmse") return d.relativeMse;
  const auto row = std::ranges::find(kStatistics, metric, &Statistic::name);
  return d.distances.*row->value;
}

}  // namespace

std::vector<std::string> metricNames() {
  std::vector<std::string> names;
  for (const Statistic& statistic : kStatistics) names.emplace_back(statistic.name);
  names.insert(names.end(), {"rmse", "relmse", "flip", "ldrflip"});
  return names;
}

Measured measure(const Image& a, const Image& reference, const Bound& bound) {
  Measured all{compare(a, reference, bound.tolerance), {}, {}};
  if (bound.metric == "flip" || bound.metric == "ldrflip") {
    all.pixels = bound.metric == "flip" ? hdrFlip(a, reference) : ldrFlip(a, reference);
    all.flip = distributionOf(all.pixels, bound.tolerance);
  } else {
    all.pixels = largestDistances(a, reference);
  }
  return all;
}

double figureOf(const Measured& measured, const Bound& bound) {
  double worst = 0.0;
  const auto add = [&](const Distribution& distribution, double value) {
    const double figure = bound.maxShare ? distribution.share : value;
    worst = std::isnan(figure) ? std::numeric_limits<double>::infinity() : std::max(worst, figure);
  };
  if (measured.flip) {
    add(*measured.flip, measured.flip->mean);
  } else {
    for (const ChannelDifference& d : measured.channels) add(d.distances, valueOf(d, bound.metric));
  }
  return worst;
}

}  // namespace laver
