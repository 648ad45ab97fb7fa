#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lab/chart/numbers.h"

namespace laver::bench {

using chart::quantile;
inline double median(const std::vector<double>& values) { return quantile(values, 0.5); }

/// Measurements, printed as they come and kept for files; the summary comes last in print and first
/// in Markdown.
class Report {
 public:
  /// Date, machine, and versions of what is measured, by name.
  explicit Report(const nlohmann::json& about);

  void section(const std::string& title, const nlohmann::json& facts);

  /// One line: median and quartiles of `seconds`, Mray/s where `rays` is above 0, and the ratio of
  /// the median to `against` where that is above 0.
  void timing(const std::string& name, const std::vector<double>& seconds, double rays = 0,
              double against = 0);

  /// One line of the summary.
  void figure(const std::string& name, double value, const std::string& unit);
  void printSummary() const;

  /// JSON with every single time.
  void saveJson(const std::string& file) const;
  /// Keeps a Markdown file up to its line `<!-- figures -->` and replaces what follows by tables.
  /// Throws Error(Output) where it has no such line.
  void saveMarkdown(const std::string& file) const;

 private:
  std::string summary() const;
  std::string markdown() const;
  nlohmann::json about_, sections_ = nlohmann::json::array(), figures_ = nlohmann::json::array();
};

}  // namespace laver::bench
