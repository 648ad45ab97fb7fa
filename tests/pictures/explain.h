#pragma once
#include "image/image.h"
#include "lab/explain/judge.h"
#include "reference/reference.h"
#include "scene/scene.h"

namespace laver::test {

/// Maximum share of pixels that rounding may change: it moves samples by about 1e-3 pixels, edges
/// cross most pixels of a detailed picture, and about ten samples contribute to a pixel: 1e-2,
/// doubled.
inline constexpr double kMaxExplained = 0.02;

/// Expects few differences beyond `tolerance`, all of them explained.
void expectExplained(const Image& image, const Image& truth, const Scene& scene,
                     const Reference& reference, double tolerance);

/// Expects the same bits from all traversals, equal to the reference except for samples near a
/// decision.
void expectTraversalsMatch(const Scene& scene, double tolerance);

}  // namespace laver::test
