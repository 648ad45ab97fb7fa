#pragma once
#include <string>
#include <vector>

#include "lab/suite/run.h"

namespace laver::suite {

/// Numbers of results by verdict.
struct Counts {
  std::size_t passed = 0, failed = 0, skipped = 0;
  double seconds = 0.0;  ///< of all tests together
};
Counts countsOf(const std::vector<Result>& results);

/// One line without its end: verdict, name, seconds, figure and reason.
std::string lineOf(const Result& result);

/// For example "12 passed, 1 failed, 0 skipped".
std::string summaryOf(const Counts& counts);

/// "passed", "failed" or "skipped".
std::string nameOf(Verdict verdict);

/// A text that XML and HTML can hold, as UTF-8: other bytes and control characters are replaced.
std::string printable(const std::string& text);

/// JUnit's XML. `folder` is the name of the suite.
std::string junitOf(const std::vector<Result>& results, const std::string& folder);

/// One HTML page with all pictures: failed tests first, then by figure relative to its tolerance.
std::string htmlOf(const std::vector<Result>& results, const std::string& folder);

}  // namespace laver::suite
