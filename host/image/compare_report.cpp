#include "image/compare_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace laver {

std::string describe(const std::vector<ChannelDifference>& differences, double tolerance) {
  using Row = std::array<std::string, 6>;
  std::vector<Row> rows = {{"channel", "RMSE", "relative MSE", "maximum", "99.9th percentile",
                            fmt::format("beyond {:g}", tolerance)}};
  for (const ChannelDifference& d : differences) {
    rows.push_back({d.channel, fmt::format("{:.4g}", d.rmse), fmt::format("{:.4g}", d.relativeMse),
                    fmt::format("{:.4g}", d.maximum), fmt::format("{:.4g}", d.percentile999),
                    fmt::format("{:.4g} %", 100.0 * d.share)});
  }
  std::array<std::size_t, 6> widths{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string table;
  for (const Row& row : rows) {
    table += fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) {
      table += fmt::format("  {:>{}}", row[i], widths[i]);
    }
    table += '\n';
  }
  return table;
}

}  // namespace laver
