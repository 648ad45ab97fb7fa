#pragma once
#include <vector>

#include "image/image.h"
#include "reference/reference.h"
#include "scene/render_options.h"

namespace laver::test {

/// Pixels that differ from the reference beyond a tolerance, and how many of them no sample near a
/// decision explains.
struct Explanation {
  int differing = 0;
  int unexplained = 0;
  std::string first;  ///< the first unexplained pixel, for the message
};

/// A pixel is explained if one of the samples that its filter reaches is not decided: moved by
/// `delta` pixels it would meet another surface or another light. See kDelta.
Explanation explain(const Image& image, const Image& truth, const Scene& scene,
                    const Reference& reference, double tolerance);

/// Both traversals give the same bits, equal to the reference but for samples near a decision.
void expectTraversalsMatch(const Scene& scene, double tolerance);

/// The kernels' rays and vertices are rounded to float. At a film of w pixels and T = tan(fov / 2)
/// a pixel is 2 T / w in the ray's slope; rounding of film position, camera columns, vertices and
/// barycentrics moves a hit by about 16 * 2^-24 (|o| + 1) / distance in slope at most, in scenes
/// whose camera stands a few sizes away: 16 * 6e-8 * 768 / (2 * 0.23) = 0.0016 pixels at the
/// largest film of scenes/, and as much again for the shadow ray's end.
inline constexpr double kDelta = 0.004;

}  // namespace laver::test
