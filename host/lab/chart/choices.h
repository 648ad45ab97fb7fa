#pragma once
#include <string>
#include <vector>

#include "scene/scene.h"

namespace laver::chart {

/// A way to render, but for how much: one line of points in the chart.
struct Series {
  std::string program;  ///< "laver", or the name of another that takes the same options
  std::string sampler;  ///< as --sampler has it; empty: the program has no other
  const FilterRow* filter;
  std::string traversal;  ///< as --traversal has it; empty: what the device does best
  bool adaptive = false;  ///< by --error in place of --spp
};

/// "sobol, box, lane"
std::string nameOf(const Series& series);

/// One point of a series.
struct Choice {
  Series series;
  std::uint32_t samples = 0;  ///< a pixel; 0: adaptive
  double error = 0;           ///< what an adaptive one is asked for
  std::uint32_t most = 0;     ///< samples a pixel that it may take

  /// The options of the command line, that which comes before and after them left out.
  std::vector<std::string> arguments() const;
};

/// Names of other programs that take laver's options, and how to start them.
struct Program {
  std::string name, file;
};

/// The combinations that make sense for a scene: every sampler with every filter; with the
/// scene's own filter adaptively too, and by each of `traversals`; each of `programs` with every
/// sampler and filter. `mostSamples` bounds the samples a pixel.
std::vector<Choice> choicesFor(const Scene& scene, const std::vector<Program>& programs,
                               const std::vector<std::string>& traversals,
                               std::uint32_t mostSamples);

/// The traversals beside the one that a device takes `unasked`; none beside lane, which may be all
/// that it has.
std::vector<std::string> traversalsBeside(const std::string& unasked);

/// Numbers of the choices that differ by the program alone, side by side.
std::vector<std::vector<std::size_t>> sameButForProgram(const std::vector<Choice>& choices);

/// The filters of all series, the scene's own first.
std::vector<Filter> filtersFor(const Scene& scene);

}  // namespace laver::chart
