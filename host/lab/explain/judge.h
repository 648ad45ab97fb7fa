#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "image/image.h"
#include "reference/reference.h"
#include "reference/rounding.h"
#include "scene/scene.h"

namespace laver {

/// Decides whether rounding explains a difference from the reference: it does if one of eight rays
/// around a sample's ray, displaced as far as Rounding allows, has another hit or value. Features
/// narrower than that displacement may be missed.
class Judge {
 public:
  /// Both must outlive this object; the reference must be of that scene.
  Judge(const Scene& scene, const Reference& reference);

  const Rounding& rounding() const { return rounding_; }

  /// Rounding may change which primitive the ray through a film position hits, or whether it hits
  /// any.
  bool otherHit(glm::dvec2 film) const;
  /// Rounding may make the ray hit that primitive, or none, at a distance from the camera.
  bool mayHit(glm::dvec2 film, std::optional<std::uint32_t> id, double distance) const;
  /// Rounding may change the sample's value by more than `difference` in a channel.
  bool otherValue(glm::dvec2 film, const reference::Numbers& numbers, double difference) const;

  /// The same for any sample within reach of a pixel's filter: one that hits another primitive, or
  /// one whose value changes by half of the pixel's difference. A single sample weighs less than
  /// the pixel; half, because surfaces beyond an edge are shaded slightly differently.
  bool pixelSeesOtherHit(int x, int y) const;
  bool explainsPixel(int x, int y, double difference) const;

 private:
  double nearestDistance(glm::dvec2 film) const;

  const Scene& scene_;
  const Reference& reference_;
  Rounding rounding_;
  double nearest_;  // hit in the film
};

/// Differences between a picture and the reference's picture of the same samples.
struct PixelDifferences {
  std::uint64_t differing = 0;    ///< pixels beyond the tolerance
  std::uint64_t unexplained = 0;  ///< those that Judge does not explain
  std::string first;              ///< the first unexplained pixel, in rows from the top
};

/// Counts pixels whose R, G or B differ by more than `tolerance` * max(1, value) or are NaN.
PixelDifferences explainPixels(const Image& image, const Image& truth, const Judge& judge,
                               double tolerance, unsigned threads = 0);

}  // namespace laver
