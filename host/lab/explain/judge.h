#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "image/image.h"
#include "reference/reference.h"
#include "reference/rounding.h"
#include "scene/scene.h"

namespace laver {

/// Says whether rounding explains a difference from the reference: whether one of eight rays around
/// a sample's, moved as far as Rounding allows, sees something else. What is narrower may pass
/// between them.
class Judge {
 public:
  /// Both outlive it; the reference is of that scene.
  Judge(const Scene& scene, const Reference& reference);

  const Rounding& rounding() const { return rounding_; }

  /// Rounding may make the ray through a film position meet another primitive, or none.
  bool otherHit(glm::dvec2 film) const;
  /// Rounding may make it meet that primitive, or none, at a distance from the camera.
  bool mayHit(glm::dvec2 film, std::optional<std::uint32_t> id, double distance) const;
  /// Rounding may change the sample's value by more than `difference` in a channel.
  bool otherValue(glm::dvec2 film, const reference::Numbers& numbers, double difference) const;

  /// The same for some sample that the filter of a pixel reaches: one that meets another primitive,
  /// or one whose value changes by half of the pixel's difference. A sample weighs less than the
  /// pixel; half, because what lies beyond an edge is shaded a little differently there.
  bool pixelSeesOtherHit(int x, int y) const;
  bool explainsPixel(int x, int y, double difference) const;

 private:
  double nearestDistance(glm::dvec2 film) const;

  const Scene& scene_;
  const Reference& reference_;
  Rounding rounding_;
  double nearest_;  // of all that the film shows
};

/// A picture beside the reference's of the same samples.
struct PixelDifferences {
  std::uint64_t differing = 0;    ///< pixels beyond the tolerance
  std::uint64_t unexplained = 0;  ///< of these: Judge finds no reason
  std::string first;              ///< the first unexplained one, in rows from the top
};

/// Pixels whose R, G or B differ by more than `tolerance` times max(1, value), or are NaN.
PixelDifferences explainPixels(const Image& image, const Image& truth, const Judge& judge,
                               double tolerance, unsigned threads = 0);

}  // namespace laver
