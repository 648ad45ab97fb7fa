#pragma once
#include <cstdint>
#include <glm/glm.hpp>

#include "scene/cameras.h"
#include "scene/samplers.h"

namespace laver::reference {

/// A sample, identified by its pixel and its number.
struct PixelSample {
  int x, y;
  std::uint32_t sample;
};

/// The film position, in pixels, of a sample: dimension 0 of its random numbers.
inline glm::vec2 samplePosition(const Camera& camera, const Sampler& sampler, int x, int y,
                                std::uint32_t sample) {
  return sampler.row->position(camera, sampler, {x, y, sample});
}

/// The random numbers of a sample, pairs in [0, 1) by dimension. Dimension 1 is the aperture's,
/// which a pinhole camera leaves to integrators; paths use the further ones.
class Numbers {
 public:
  Numbers(const Camera& camera, const Sampler& sampler, const PixelSample& at)
      : camera_(&camera), sampler_(&sampler), at_(at) {}
  /// Returns the same pair for each dimension.
  Numbers(glm::dvec2 all) : all_(all) {}  // NOLINT(google-explicit-constructor)

  glm::dvec2 pair(std::uint32_t dimension) const {
    const glm::dvec2 numbers =
        camera_ == nullptr ? all_
                           : glm::dvec2(sampler_->row->pair(*camera_, *sampler_, at_, dimension));
    return glm::clamp(numbers + moved_, 0.0, 1.0);
  }

  /// All pairs shifted by the same amount, within [0, 1].
  Numbers moved(glm::dvec2 by) const {
    Numbers numbers = *this;
    numbers.moved_ += by;
    return numbers;
  }

 private:
  const Camera* camera_ = nullptr;
  const Sampler* sampler_ = nullptr;
  PixelSample at_{};
  glm::dvec2 all_{0.5}, moved_{0.0};
};

}  // namespace laver::reference
