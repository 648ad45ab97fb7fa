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

}  // namespace laver::test
