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

  /// Pictures of noise s and t differ by sqrt(s^2 + t^2), and the two renders by sqrt(2) s. Twice
  /// as much leaves room for t = sqrt(7) s, as other renderers choose lights and end paths
  /// otherwise. Half a percent of the mean is half of what an eye tells apart (Weber's fraction of
  /// luminance, 1 %).
  bool holds() const;
  std::string row(const std::string& name) const;  ///< of a Markdown table
};

/// The pictures must be of one size: throws std::invalid_argument.
Agreement agreementOf(const Image& render, const Image& other, const Image& published);

}  // namespace laver::test
