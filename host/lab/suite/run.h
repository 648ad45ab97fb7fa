#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lab/suite/discover.h"
#include "lab/suite/settings.h"

namespace laver::suite {

struct Options {
  std::string self;                  ///< the program that renders: laver
  std::vector<std::string> options;  ///< of every render
  CheckOptions check;
  std::size_t jobs = 1;           ///< tests that run at once
  double timeout = 600.0;         ///< seconds that a test may take
  bool accept = false;            ///< write expected pictures that are missing or differ
  bool pictures = false;          ///< keep pictures in the results
  std::string skip;               ///< why every test is skipped; empty: none is
  std::function<bool()> stopped;  ///< whether to end
};

enum class Verdict { Passed, Failed, Skipped };

/// The difference of a picture from the expected one.
struct Figure {
  std::string text;    ///< for example "p99 2e-07, tolerance 0.001"
  double share = 0.0;  ///< of what is tolerated
  bool within = true;
};
Figure figureOf(double value, const Bound& bound);
Figure figureOf(const NoiseTest& test, const NoiseLimits& limits);

struct Result {
  std::string name;
  Verdict verdict = Verdict::Failed;
  double seconds = 0.0;
  std::optional<Figure> figure;
  std::string reason;  ///< why it failed or was skipped; may have several lines
  std::string change;  ///< of the expected picture, where pictures are accepted
  std::string output;  ///< what laver printed: warnings, and hypotheses
  /// PNG files; empty if there is none.
  std::vector<std::byte> actual, expected, difference;
};

/// Runs a test in a process of its own, so that a driver that crashes fails that test only. Throws
/// nothing that one test causes.
Result runTest(const Test& test, const Options& options);

/// Runs all tests and reports each result in the order of `tests`, on the caller's thread. Returns
/// fewer results than tests if it was stopped.
std::vector<Result> runTests(const std::vector<Test>& tests, const Options& options,
                             const std::function<void(const Result&)>& report);

}  // namespace laver::suite
