#pragma once
#include "lab/chart/chart.h"
#include "lab/chart/figure.h"

namespace laver::chart {

/// More curves than these in one panel cannot be told apart.
inline constexpr std::size_t kMaxCurves = 6;

/// What a chart's SVG and PNG show. Panels without a curve are left out.
Figure figureOf(const Chart& chart);

}  // namespace laver::chart
