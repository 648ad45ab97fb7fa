#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/numeric.h"
#include "lab/chart/numbers.h"

namespace laver::bench {

inline double median(const std::vector<double>& values) { return quantile(values, 0.5); }

/// Measurements, printed as they are made and kept for files. The summary is printed last and comes
/// first in Markdown.
class Report {
 public:
  /// `about`: date, machine, and versions of the measured programs.
  explicit Report(const nlohmann::json& about);

  void section(const std::string& title, const nlohmann::json& facts);

  /// One line: median and quartiles of `seconds`, Mray/s if `rays` > 0, and the ratio of the median
  /// to `against` if that is > 0.
  void timing(const std::string& name, const std::vector<double>& seconds, double rays = 0,
              double against = 0);

  /// One line of the summary.
  void figure(const std::string& name, double value, const std::string& unit);
  void printSummary() const;

  /// JSON with every measured time.
  void saveJson(const std::string& file) const;
  /// Replaces the part of a Markdown file after its line `<!-- figures -->` by tables. Throws
  /// Error(Output) if it has no such line.
  void saveMarkdown(const std::string& file) const;

 private:
  std::string summary() const;
  std::string markdown() const;
  nlohmann::json about_, sections_ = nlohmann::json::array(), figures_ = nlohmann::json::array();
};

}  // namespace laver::bench
