#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "image/measure.h"
#include "image/noise_test.h"

namespace laver::suite {

/// 1e-3 is a quarter of a step of an 8-bit picture. Between the device and the reference, the 99th
/// percentile is at most 6e-6 in the ready scenes (64 x 48 pixels, 16 samples), while single pixels
/// differ by 0.01, where rounding puts a sample on the other side of an edge; so it does between
/// drivers. The noise of another seed, or a changed material, is far beyond it.
inline const Bound kDefaultBound = {"p99", 1e-3, {}};

/// How a scene is rendered and judged as a test.
struct Settings {
  Bound bound = kDefaultBound;
  std::optional<NoiseLimits> noise;  ///< in place of the bound; the options render variances
  std::vector<std::string> options;  ///< of `laver SCENE.xml`
};

/// What makes a scene a test, for --help.
std::string help();

/// Throws Error(Usage) if `laver SCENE.xml` does not take these options.
using CheckOptions = std::function<void(const std::vector<std::string>& options)>;

/// Reads SCENE.test.json. Throws Error(Scene) with one `file:line:col: error: ...` line for every
/// error found.
Settings readSettings(const std::string& file, const CheckOptions& check);

}  // namespace laver::suite
