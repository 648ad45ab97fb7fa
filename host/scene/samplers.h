#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/property.h"
#include "scene/rows.h"

namespace laver {

struct Camera;
struct Sampler;

namespace reference {
struct PixelSample;
}

/// A sampler. Its GLSL is shaders/sampler/NAME.glsl, its counterpart in the reference
/// host/reference/sampler/NAME.cpp.
struct SamplerRow {
  const char* name;                      ///< in scenes and on the command line
  std::vector<const char*> spellings{};  ///< other names in scenes
  const char* object = "";               ///< in the dump
  std::vector<PropertyRow> properties{};
  bool stream = false;     ///< Nori's generator, one per block of 32 x 32 pixels
  bool strata = false;     ///< one sample in each of strataOf(sampleCount)
  bool countFree = false;  ///< samples do not depend on the sample count
  bool adaptive = false;   ///< any first samples of a pixel cover it evenly
  /// The film position in pixels.
  glm::vec2 (*position)(const Camera& camera, const Sampler& sampler,
                        const reference::PixelSample& at) = nullptr;
  /// Two numbers in [0, 1) for a dimension >= 1; dimension 1 is the aperture's.
  glm::vec2 (*pair)(const Camera& camera, const Sampler& sampler, const reference::PixelSample& at,
                    std::uint32_t dimension) = nullptr;
};

namespace samplers {
/// Rows that other code refers to.
extern const SamplerRow independent, stratified, sobol;
}  // namespace samplers

const Rows<SamplerRow>& samplerRows();

/// The sampler of a scene.
struct Sampler {
  std::uint32_t sampleCount = 1;  ///< per pixel
  std::int64_t seed = 0;
  const SamplerRow* row = &samplers::independent;
};

/// Columns and rows of strata: the factors of the count that are closest to each other, the smaller
/// one first.
glm::uvec2 strataOf(std::uint32_t sampleCount);

}  // namespace laver
