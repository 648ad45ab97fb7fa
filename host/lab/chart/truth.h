#pragma once
#include <string>

#include "lab/chart/chart.h"
#include "lab/chart/measure.h"

namespace laver::chart {

/// A converged picture: the mean of two halves with different seeds, neither of which is the
/// scene's.
struct Truth {
  Image image;         ///< R, G, B
  double error = 0;    ///< estimate of its RMSE: half the RMSE between the halves
  std::string origin;  ///< what made it, and how it was tested
};

/// By the double-precision reference, which takes minutes for paths. So these are rendered by the
/// device, if testNoise() finds its picture equal to the reference's of a sixteenth of the samples,
/// in means of blocks of pixels; otherwise the reference renders all. `say` of the options tells.
/// Throws Error and Stopped.
Truth truthOf(const Scene& scene, const Options& options, const Measurement& measurement);

/// The share of the chart's work that it is.
inline constexpr double kTruthEnd = 0.4;

}  // namespace laver::chart
