#pragma once
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"

namespace laver::chart {

/// One render by a process of its own.
// NOLINTNEXTLINE(bugprone-exception-escape): moving JSON asserts, and throws nothing
struct Run {
  double seconds = 0;    ///< from the start of the process to its end
  nlohmann::json stats;  ///< what its --stats=FILE.json left
};

/// Renders by processes that take laver's options. Their files lie in a folder and are removed.
class Runner {
 public:
  explicit Runner(std::string folder) : folder_(std::move(folder)) {}
  ~Runner();
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;

  /// `program arguments... -o FILE.exr --stats=FILE.json --quiet`. Throws Error with the code and
  /// the last line of stderr of a process that fails; none where `stop` says why it ended.
  std::optional<Run> run(const std::string& program, std::vector<std::string> arguments,
                         const std::function<bool()>& stop) const;

  /// The picture of the latest run.
  Image picture() const;

 private:
  std::string file(const char* extension) const { return folder_ + "/running" + extension; }
  std::string folder_;
};

}  // namespace laver::chart
