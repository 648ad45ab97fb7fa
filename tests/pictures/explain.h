#pragma once
#include <vector>

#include "image/image.h"
#include "reference/reference.h"
#include "render/options.h"

namespace laver::test {

/// Pixels that differ from the reference beyond a tolerance, and how many of them no sample near a
/// decision explains.
struct Explanation {
  int differing = 0;
  int unexplained = 0;
  std::string first;  ///< the first unexplained pixel, for the message
};

/// A pixel is explained if one of the samples that its filter reaches is not decided: moved by
/// movedBy() pixels, or its direction turned by kTurn, it would meet another surface or light.
Explanation explain(const Image& image, const Image& truth, const Scene& scene,
                    const Reference& reference, double tolerance);

/// All traversals give the same bits, equal to the reference but for samples near a decision.
void expectTraversalsMatch(const Scene& scene, double tolerance);

/// How far rounding moves a sample at most, in pixels. The kernels' rays and vertices are rounded
/// to float: film position, camera columns, vertices and barycentrics move a hit by about 16 *
/// 2^-24 (|o| + 1) / distance in slope, in units of the scene's half-width, and the shadow ray's
/// end by as much again. A pixel is 2 tan(fov / 2) / width in slope.
double movedBy(const Scene& scene, const Reference& reference);

/// By how much a drawn direction may be turned, in radians: the error of the shading normal that it
/// is drawn around, 25 * 2^-24 at triangles that are no slivers (stability, case 9). The numbers
/// that choose it move by no more.
inline constexpr double kTurn = 25.0 / (1 << 24);

}  // namespace laver::test
