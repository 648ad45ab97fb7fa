#pragma once
#include <string>

#include "image/image.h"

namespace laver::test {

/// How a picture agrees with a published one of the same scene and number of samples, whose noise
/// is not known: by their means, and by blocks of 8 x 8 pixels, whose difference is measured
/// against that of two renders with different seeds.
struct Agreement {
  double mean, wantedMean;
  double difference;  ///< root mean square over blocks and channels, to the published picture
  double noise;       ///< the same between the two renders

  /// Two independent pictures of equal noise differ by `noise` in the mean. Twice as much leaves
  /// room for a published picture that is noisier by a factor of 1.7, as others choose lights and
  /// end paths otherwise; a shift of the camera by a pixel is well beyond it. Half a percent is
  /// half of what an eye tells apart (Weber's fraction of luminance, 1 %).
  bool holds() const;
  std::string row(const std::string& name) const;  ///< of a Markdown table
};

/// The pictures must be of one size: throws std::invalid_argument.
Agreement agreementOf(const Image& render, const Image& other, const Image& published);

}  // namespace laver::test
