#pragma once
#include "image/image.h"
#include "lab/explain/judge.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace laver::test {

/// Greatest share of pixels that may differ from the reference for reasons of rounding. Rounding
/// moves samples by about 1e-3 pixels, an edge passes most pixels of a detailed picture, and some
/// ten samples contribute to a pixel.
inline constexpr double kMaxExplained = 0.02;

/// Expects few differences beyond `tolerance`, all of them explained.
void expectExplained(const Image& image, const Image& truth, const Scene& scene,
                     const Reference& reference, double tolerance);

/// Expects the same bits from all traversals, equal to the reference except for samples near a
/// decision.
void expectTraversalsMatch(const Scene& scene, double tolerance);

}  // namespace laver::test
