#pragma once
#include <map>
#include <string>
#include <vector>

#include "lab/chart/chart.h"
#include "lab/chart/kept.h"
#include "lab/chart/run.h"

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

  /// Renders each options.runs times after a time that warms caches up, and keeps what that gave:
  /// in turns, so that whatever else the machine does falls on all alike, and all anew where one is
  /// not kept. Throws Error and Stopped.
  void measureInTurns(const std::vector<Choice>& choices) const;

  /// What measureInTurns kept. Throws Error(Output) where it is not there.
  Measured measured(const Choice& choice) const;

 private:
  struct Started {
    std::string file, fingerprint;
  };
  void addRun(const Choice& choice, bool counts, nlohmann::json& record) const;
  /// Those of the latest picture.
  nlohmann::json pixels(const std::string& program) const;

  const Options& options_;
  const Kept& kept_;
  Runner runner_;
  std::map<std::string, Started> programs_;
  std::string sceneKey_;
};

}  // namespace laver::chart
