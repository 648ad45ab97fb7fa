#pragma once
#include <vector>

#include "image/image.h"

namespace laver {

/// The differences that an observer sees between two pictures that alternate on a screen, per
/// pixel, in [0, 1]: FLIP (Andersson et al., "FLIP: A Difference Evaluator for Alternating Images",
/// HPG 2020) at 67 pixels per degree, from R, G, B in linear values that are clamped to [0, 1].
/// Pixels that are not finite are black, and differ by 1. Throws Error(Usage) if the sizes differ,
/// or if a picture lacks R, G or B.
std::vector<double> ldrFlip(const Image& a, const Image& reference);

/// The maximum per pixel over exposures, from the one that maps the reference's brightest pixel to
/// 0.85 to the one that maps its median there: HDR-FLIP (Andersson et al., "Visualizing Errors in
/// Rendered High Dynamic Range Images", Eurographics 2021), with the ACES tone mapper.
std::vector<double> hdrFlip(const Image& a, const Image& reference);

}  // namespace laver
