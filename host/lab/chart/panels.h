#pragma once
#include "lab/chart/chart.h"
#include "lab/chart/figure.h"

namespace laver::chart {

/// More curves than these cannot be distinguished in one panel.
inline constexpr std::size_t kMaxCurves = 6;

/// The figure of a chart's SVG and PNG. Panels without curves are left out.
Figure figureOf(const Chart& chart);

}  // namespace laver::chart
