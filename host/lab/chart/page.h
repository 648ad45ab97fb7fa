#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "image/bitmap.h"
#include "lab/chart/chart.h"

namespace laver::chart {

nlohmann::json jsonOf(const Chart& chart);

/// One line a point under one line of headings.
std::string csvOf(const Chart& chart);

/// One file, well-formed as XML too, that needs no other: drawings, pictures and all. `metric` is
/// shown first.
std::string pageOf(const Chart& chart, const std::string& metric);

/// The panels of the scene's own filter, of the next, and panel C.
Bitmap bitmapOf(const Chart& chart, const std::string& metric);

/// Error over samples of each series that has several.
std::vector<std::pair<std::string, double>> slopesOf(const Chart& chart);

}  // namespace laver::chart
