#pragma once
#include "image/image.h"
#include "lab/explain/judge.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace laver::test {

/// Pixels that may differ from the reference for reasons of rounding, as a share of all: rounding
/// moves samples by 1e-3 pixels or so, an edge passes most pixels of a detailed picture, and some
/// ten samples reach a pixel.
inline constexpr double kMaxExplained = 0.02;

/// Differences beyond `tolerance` are few, and all are explained.
void expectExplained(const Image& image, const Image& truth, const Scene& scene,
                     const Reference& reference, double tolerance);

/// All traversals give the same bits, equal to the reference but for samples near a decision.
void expectTraversalsMatch(const Scene& scene, double tolerance);

/// How far rounding moves a sample at most, in pixels. The kernels' rays and vertices are rounded
/// to float: film position, camera columns, vertices and barycentrics move a hit by about 16 *
/// 2^-24 (|o| + 1) / distance in slope, in units of the scene's half-width, and the shadow ray's
/// end by as much again. A pixel is 2 tan(fov / 2) / width in slope.
double movedBy(const Scene& scene, const Reference& reference);

/// By how much a drawn direction may be turned, in radians: the error of the shading normal that it
/// is drawn around, 25 * 2^-24 at triangles that are no slivers (the stability case Slivers). The
/// numbers that choose it move by no more.
inline constexpr double kTurn = 25.0 / (1 << 24);

}  // namespace laver::test
