#pragma once
#include <map>
#include <string>
#include <vector>

#include "chart/chart.h"
#include "chart/kept.h"
#include "chart/run.h"

namespace laver::chart {

/// Thrown where options.stop ended the work; makeChart hands no chart back then.
struct Stopped {};
inline void throwIfStopped(const Options& options) {
  if (options.stop && options.stop()) throw Stopped{};
}

/// What the renders of a choice gave.
struct Measured {
  std::vector<double> passSeconds, processSeconds;
  double samples = 0;  ///< a pixel, pilots too
  Image image;
};

/// Runs the programs of a chart, or finds what they gave before.
class Measurer {
 public:
  Measurer(const Options& options, const Kept& kept);

  /// What all its points depend on.
  const std::string& sceneKey() const { return sceneKey_; }
  /// What the measurement of a choice depends on, and that of laver's methods.
  std::string keyOf(const Choice& choice) const;
  std::string keyOfMethods() const;

  /// Scene, size, device and threads.
  std::vector<std::string> commonArguments() const;

  /// One render. Throws Error and Stopped.
  Run runOnce(const std::string& program, const std::vector<std::string>& arguments) const;

  /// options.runs renders after one that warms caches up, if none are kept.
  Measured measure(const Choice& choice) const;

 private:
  struct Started {
    std::string file, fingerprint;
  };
  nlohmann::json renders(const Choice& choice) const;

  const Options& options_;
  const Kept& kept_;
  Runner runner_;
  std::map<std::string, Started> programs_;
  std::string sceneKey_;
};

}  // namespace laver::chart
