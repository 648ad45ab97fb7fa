#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace laver::chart {

/// Finished parts of a chart in a folder, each under a key that says all that it depends on. What
/// is damaged, of another format or of another key counts as not there.
class Kept {
 public:
  /// Makes the folder where there is none. Throws Error(Output).
  explicit Kept(std::filesystem::path folder);

  /// None if nothing of that key is there whole.
  std::optional<nlohmann::json> read(const std::string& key) const;

  /// Throws Error(Output). JSON may hold binary values.
  void write(const std::string& key, const nlohmann::json& value) const;

  std::filesystem::path fileOf(const std::string& key) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace laver::chart
