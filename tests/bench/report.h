#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/numeric.h"

namespace laver::bench {

inline double median(const std::vector<double>& values) { return quantile(values, 0.5); }

/// Measurements, printed as they come and kept for a JSON file; at the end the figures wanted.
class Report {
 public:
  void section(const std::string& title, const nlohmann::json& facts);

  /// One line: median and quartiles of `seconds`, Mray/s where `rays` is above 0, and, where
  /// `against` is, how many times as long it takes.
  void timing(const std::string& name, const std::vector<double>& seconds, double rays = 0,
              double against = 0, const nlohmann::json& more = nullptr);

  void figure(const std::string& name, double got, const std::string& wanted,
              const std::string& unit = "");
  void printFigures() const;
  void save(const std::string& file) const;

 private:
  nlohmann::json sections_ = nlohmann::json::array(), figures_ = nlohmann::json::array();
};

}  // namespace laver::bench
